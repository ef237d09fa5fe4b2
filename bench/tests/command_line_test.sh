#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What a user sees of fixbench: good calls write their files, bad ones get one clear line and a
# non-zero exit. Usage: command_line_test.sh FIXBENCH SCRATCH_FOLDER
set -u
fixbench=$1
scratch=$2
rm -rf "$scratch" && mkdir -p "$scratch"
failures=0

fail() { echo "FAILED: $*"; failures=$((failures + 1)); }

# refuses TEXT ARGUMENTS...: exits non-zero, says TEXT on stderr, does not crash.
refuses() {
    local text=$1 status
    shift
    "$fixbench" "$@" >"$scratch/out" 2>"$scratch/err" </dev/null
    status=$?
    [ $status -ne 0 ] && [ $status -lt 128 ] || fail "fixbench $*: exit $status"
    grep -qF -- "$text" "$scratch/err" "$scratch/out" || fail "fixbench $*: no '$text' in: $(cat "$scratch/err")"
}

refuses "subcommand" # nothing asked for
refuses "--frobnicate" cycles --frobnicate
refuses "selected" cycles --operation frobnicate --output "$scratch/a"
refuses "does not exist" cycles --program "$scratch/absent.elf"
echo "not an ELF" >"$scratch/text.elf"
refuses "text.elf" cycles --program "$scratch/text.elf" --output "$scratch/a"
refuses "samples" cycles --samples 0
refuses "selected" accuracy --format q7_1 --output "$scratch/a"
refuses "selected" verify --operation add --format float --output "$scratch/a"
: >"$scratch/file"
refuses "cannot write" cycles --operation add --format q16_16 --implementation default --operands small \
    --samples 1 --output "$scratch/file/below"
refuses "missing" report --results "$scratch/absent"
[ -e "$scratch/a" ] && fail "a refused run has written files"

for command in cycles accuracy table verify report; do
    "$fixbench" $command --help | grep -q "Example\|Writes\|Figures" || fail "$command --help teaches nothing"
done

"$fixbench" cycles --operation multiply --format q16_16 --implementation default --operands physics \
    --samples 10 --output "$scratch/good" 2>/dev/null || fail "cycles"
[ "$(wc -l <"$scratch/good/operations.csv")" = 2 ] || fail "operations.csv has more than one row"
head -1 "$scratch/good/operations.csv" | grep -q "^operation,format,implementation,operands,samples,cycles_min,cycles_mean,cycles_max,cycles_max_witness,max_ulp,max_ulp_witness,rms_ulp,bound,flash_bytes,stack_bytes" ||
    fail "the columns of operations.csv"
python3 -m json.tool "$scratch/good/operations.json" >/dev/null || fail "operations.json is no JSON"

[ $failures -eq 0 ] && echo "command line: all as documented"
exit $((failures != 0))
