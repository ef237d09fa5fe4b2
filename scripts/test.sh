#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# All tests: installs what is missing, builds, runs the suite on the host, on the simulated chip and
# under the sanitizers, and checks that deliberate faults are caught.
set -euo pipefail
cd "$(dirname "$0")/.."
if [ $# -gt 0 ]; then
    [ "$1" = "--help" ] && { sed -n '3,4s/^# //p' "$0"; echo "Usage: scripts/test.sh"; exit 0; }
    echo "test.sh: unknown argument '$1'; it takes none" >&2
    exit 2
fi

scripts/build.sh release
ctest --preset release --parallel "$(nproc)"
scripts/build.sh sanitize
ctest --preset sanitize --parallel "$(nproc)" --label-exclude device
