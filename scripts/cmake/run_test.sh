#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs a test for the build: prints its output only if it fails, and otherwise leaves a file.
# Usage: run_test.sh PASSED COMMAND ...
set -euo pipefail
passed=$1
shift
mkdir -p "$(dirname "$passed")"
rm -f "$passed"
if ! timeout 300 "$@" >"$passed.log" 2>&1; then
    cat "$passed.log"
    exit 1
fi
mv "$passed.log" "$passed"
