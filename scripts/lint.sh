#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Checks what needs no build: formatting (clang-format), shell scripts (shellcheck), Python
# (pyflakes), and the public headers (clang-tidy, .clang-tidy). Exit status 1 if one complains.
#
# Usage: scripts/lint.sh [--fix | --all]
#   --fix  formats the sources instead, and adds what keywords.txt lacks
#   --all  also runs clang-tidy on every source of the host, except tests: some 30 CPU-minutes
set -euo pipefail
cd "$(dirname "$0")/.."

all=''
fix=''
case ${1:-} in
    '') ;;
    --fix) fix=yes ;;
    --all) all=yes ;;
    --help) sed -n '3,/^set /{/^set /d;s/^# \{0,1\}//p}' "$0"; exit 0 ;;
    *) echo "lint.sh: unknown argument '$1'; see --help" >&2; exit 2 ;;
esac
for tool in clang-format clang-tidy-19 shellcheck; do
    command -v $tool >/dev/null || { echo "lint.sh: $tool is missing; scripts/setup.sh --tests installs it" >&2; exit 2; }
done

# Generated tables are formatted by their generators.
readarray -t cpp < <(git ls-files '*.cpp' '*.hpp' '*.h' '*.c' '*.ino' | grep -v '_table\.hpp$')
readarray -t shell < <(git ls-files '*.sh')
readarray -t python < <(git ls-files '*.py')

if [ -n "$fix" ]; then
    clang-format -i "${cpp[@]}"
    for library in fixedpoint engine firmware; do
        /usr/bin/python3 fixedpoint/tests/consumer/manifests_test.py $library --fix
    done
    exit 0
fi

status=0
clang-format --dry-run --Werror "${cpp[@]}" || status=1
shellcheck --severity=warning "${shell[@]}" .ci/run || status=1
/usr/bin/python3 -m pyflakes "${python[@]}" || status=1
for program in fixedpoint/tests/consumer/cpp/{fixedpoint,engine}.cpp; do
    clang-tidy-19 --quiet "$program" -- -std=c++17 -Ifixedpoint/src -Iengine/src || status=1
done
if [ -n "$all" ]; then
    # clang reads no header that g++ has precompiled. Sources that are compiled several at a time are
    # read through the file that includes them.
    cmake --preset release -B build/lint -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON --log-level=WARNING >/dev/null
    run-clang-tidy-19 -quiet -p build/lint \
        "^$PWD/(?!.*/tests/)(build/lint/bench|reference|bench|fixedpoint|engine|firmware)/" || status=1
fi
exit $status
