#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs a test for the build: prints its output only if it fails, and otherwise leaves a file.
# Usage: run_test.sh PASSED COMMAND ...
set -euo pipefail
passed=$1
shift
mkdir -p "$(dirname "$passed")"
rm -f "$passed"
status=0
timeout 1500 "$@" >"$passed.log" 2>&1 || status=$?
if [ $status != 0 ]; then
    cat "$passed.log"
    [ $status != 124 ] || echo "stopped after 1,500 s"
    exit 1
fi
mv "$passed.log" "$passed"
