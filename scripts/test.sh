#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# All tests: installs what is missing, builds, runs the suite on the host and on the simulated chip,
# again under the sanitizers what the host can run, and checks that deliberate faults are caught.
#
# Usage: scripts/test.sh [--help]
set -euo pipefail
cd "$(dirname "$0")/.."
if [ $# -gt 0 ]; then
    if [ "$1" = --help ]; then
        sed -n '3,/^set /{/^set /d;s/^# \{0,1\}//p}' "$0"
        exit 0
    fi
    echo "test.sh: unknown argument '$1'; see --help" >&2
    exit 2
fi

scripts/build.sh release
ctest --preset release --parallel "$(nproc)"
scripts/build.sh sanitize
ctest --preset sanitize --parallel "$(nproc)"
/usr/bin/python3 scripts/mutation_test.py
