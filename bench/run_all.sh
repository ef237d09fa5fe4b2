#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Measures everything and writes results/: sets up, builds fixbench and runs `fixbench all`, which
# builds the device programs that it reads. Arguments are those of `fixbench all`:
#
# Usage: bench/run_all.sh [--quick | --full | --check] [--exhaustive] [--only NAME,...] [--resume]
#   --full   all samples, the search over hypotheses, an hour of the lever (default); writes results/
#   --quick  the same on fewer operands and, of the scenes, with fewer programs for the chip: some
#            minutes after the build; writes build/quick/ and leaves results/ alone
#   --check  measures into build/check/ instead and fails where a deterministic file (cycles, sizes,
#            errors, hashes) differs from the committed results/
#   --exhaustive  also every input of the spaces of 2^32, on the host and as machine code: hours on
#            two cores; the other modes keep the rows of the last such run
#   --only   only these of `fixbench --list`
#   --resume leaves out what was measured with the same programs and options
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
