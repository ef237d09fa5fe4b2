#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Measures everything and writes results/: sets up, builds fixbench and runs `fixbench all`, which
# builds the device programs that it reads. The arguments are those of `fixbench all`:
#
# Usage: bench/run_all.sh [--quick | --full | --check] [--exhaustive] [--only NAME,...] [--resume]
#   --full   all samples, the search over hypotheses, an hour of the lever (default); writes results/
#   --quick  the same on fewer operands and with fewer device programs of the scenes, in some minutes
#            after the build; writes build/quick/ and leaves results/ alone
#   --check  measures into build/check/ instead and fails if a deterministic file (cycles, sizes,
#            errors, hashes) differs from the committed results/
#   --exhaustive  also runs all inputs of 2^32, on the host and as machine code, for hours on two
#            cores; otherwise the rows of the last such run are kept
#   --only   only these experiments of `fixbench --list`
#   --resume skips what was already measured with the same programs and options
set -euo pipefail
cd "$(dirname "$0")/.."
for argument in "$@"; do
    if [ "$argument" = --help ]; then
        sed -n '3,/^set /{/^set /d;s/^# \{0,1\}//p}' "$0"
        exit 0
    fi
done

scripts/build.sh release fixbench
exec build/release/bench/fixbench all "$@"
