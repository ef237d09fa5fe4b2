#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Sets up, configures, and builds targets of one preset.
# Usage: scripts/build.sh [release | sanitize] [TARGET ...]
# Default targets: of release, fixbench and what it measures; of sanitize, the host's tests.
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-release}
[ $# -eq 0 ] || shift
packages=()
case $preset in
    release) ;;
    sanitize) packages=(--tests) ;;  # clang
    *) echo "build.sh: unknown preset '$preset': release or sanitize" >&2; exit 2 ;;
esac
scripts/setup.sh "${packages[@]}"
cmake --preset "$preset" --log-level=WARNING >&2
cmake --build --preset "$preset" ${1:+--target "$@"} >&2
