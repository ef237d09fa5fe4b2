#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Sets up, configures and builds one preset: scripts/build.sh [release|sanitize]
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-release}
scripts/setup.sh
cmake --preset "$preset" --log-level=WARNING >&2
cmake --build --preset "$preset" >&2
