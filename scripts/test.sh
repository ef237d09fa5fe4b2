#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs the tests: installs what is missing, builds, runs, and says how long each part took.
#
# Usage: scripts/test.sh [--quick | --full] [--help]
#   --quick  unit tests on the host and on the simulated chip, of what has changed: for every edit
#   (none)   what must pass before a change goes in: all tests; the host's tests again under the
#            sanitizers; deliberate faults, which the tests of each folder must notice; and the main
#            job, bench/run_all.sh --quick
#   --full   the same with clang-tidy on all sources, more deliberate faults, proofs that fail without
#            each instruction instead of a sample, every standard of C++ with every compiler, four
#            minutes of fuzzing, 10^7 steps of three scenes in the chip's machine code, every scene in
#            every number format and method on the simulated chip, and an hour of random worlds
# To run one test: ctest --preset release -R NAME. Exit status: 0 if all passed, 1 if one failed,
# 2 for a wrong call.
set -euo pipefail
cd "$(dirname "$0")/.."

tier=default
for argument in "$@"; do
    case $argument in
        --quick) tier=quick ;;
        --full) tier=full ;;
        --help) sed -n '3,/^set /{/^set /d;s/^# \{0,1\}//p}' "$0"; exit 0 ;;
        *) echo "test.sh: unknown argument '$argument'; see --help" >&2; exit 2 ;;
    esac
done

times=()
report() {
    printf '\n%s tier\n' "$tier"
    printf '%s\n' "${times[@]}"
    printf '%6d s  in all\n' "$SECONDS"
}
trap report EXIT

# part NAME COMMAND ...: runs the command and notes its time, also where it fails.
part() {
    local name=$1 start=$SECONDS status=0
    shift
    printf '\n== %s\n' "$name"
    "$@" || status=$?
    times+=("$(printf '%6d s  %s%s' $((SECONDS - start)) "$name" "$([ $status = 0 ] || echo ': FAILED')")")
    [ $status = 0 ] || exit 1
}
# One more than there are cores: some tests wait for a board, a browser or a terminal. Tests that fail run
# once more by themselves: their output then ends the log, and shows whether they fail without company.
run_tests() {
    ctest --preset "$1" --no-tests=error --parallel "$(($(nproc) + 1))" --output-on-failure "${@:2}" && return
    printf '\n== tests that failed, once more\n'
    ctest --preset "$1" --rerun-failed --output-on-failure
    return 1
}

part "set-up" scripts/setup.sh --tests
if [ $tier = quick ]; then
    part "build of the unit tests" scripts/build.sh release quick_tests
    part "unit tests of what has changed since they last passed" \
        cmake --build --preset release --target run_quick_tests -- -k 0
    exit 0
fi

part "build" scripts/build.sh release tests
part "tests" run_tests release
part "sanitized build of the host's tests" scripts/build.sh sanitize
part "host's tests under the sanitizers" run_tests sanitize
faults=()
if [ $tier = full ]; then
    faults=(--full)
    part "clang-tidy on all sources" scripts/lint.sh --all
    part "proofs without each instruction, every compiler and standard" \
        env EVERY_INSTRUCTION=1 EVERY_CELL=1 ctest --preset release \
        --no-tests=error --parallel "$(nproc)" --tests-regex 'prove_|/matrix$'
    part "set-up for fuzzing" scripts/setup.sh --fuzz
    part "fuzzing" cmake --build build/release --target fuzz
    part "soak of the chip's code" cmake --build build/release --target soak
    part "every scene on the chip" build/release/bench/fixbench scenes --output build/release/all_scenes
    part "random worlds for an hour" bench/experiments/stability/tests/random_worlds.sh \
        build/release/bench/experiments/stability/world_test 3600
fi
part "deliberate faults" /usr/bin/python3 scripts/mutation_test.py "${faults[@]}"
part "main job, bench/run_all.sh --quick" bench/run_all.sh --quick
scripts/build_times.py build/release
