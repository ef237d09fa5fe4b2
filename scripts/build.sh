#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Sets up, configures and builds one preset. Usage: scripts/build.sh [release | sanitize]
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-release}
case $preset in
    release | sanitize) ;;
    *) echo "build.sh: unknown preset '$preset': release or sanitize" >&2; exit 2 ;;
esac
scripts/setup.sh
cmake --preset "$preset" --log-level=WARNING >&2
cmake --build --preset "$preset" >&2
