#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# command_line_test.sh FIXBENCH PROGRAM LEVER FOLDER: what `fixbench profile` writes and refuses.
set -euo pipefail
fixbench=$1 program=$2 lever=$3 folder=$4
name=$(basename "$program" .elf)
rm -rf "$folder"
mkdir -p "$folder"
fail() { echo "$*" >&2; exit 1; }

"$fixbench" profile "$program" --seconds 0.01 --output "$folder/data" >"$folder/table" 2>/dev/null
for file in "profile_$name.csv" "interrupts_$name.csv" "stack_$name.csv" "stacks_$name.folded" "${name}_flame.svg"; do
    [ -s "$folder/data/$file" ] || fail "$file was not written"
done
# Self cycles sum to the time that was asked for, up to its last instruction or sleep.
awk '{ sum += $NF } END { exit !(sum >= 160000 && sum < 160010) }' "$folder/data/stacks_$name.folded" ||
    fail "stacks.folded does not sum to 0.01 s"
awk -F, '{ sum += $4 } END { exit !(sum >= 160000 && sum < 160010) }' "$folder/data/profile_$name.csv" ||
    fail "profile.csv does not sum to 0.01 s"
grep -q '^11,TIMER1_COMPA_vect,' "$folder/data/interrupts_$name.csv" || fail "no interrupt was recorded"
grep -q 'at most .* by the machine code' "$folder/table" || fail "no stack bound was printed"
/usr/bin/python3 -c 'import sys, xml.dom.minidom as m; m.parse(sys.argv[1])' "$folder/data/${name}_flame.svg"

# In the closed loop the lever converts, steps, draws and pulses, the same way each time.
for run in first second; do
    "$fixbench" profile "$lever" --scenario bounce --seconds 0.3 --output "$folder/$run" \
        --figures "$folder/$run/figures" >"$folder/table" 2>/dev/null
    [ -s "$folder/$run/figures/lever_flame.svg" ] || fail "the figure is not where it was asked for"
done
diff -r "$folder/first" "$folder/second" || fail "two profiles of the same run differ"
awk -F, '$2 == "ADC_vect" && $4 > 2500 || $2 == "TIMER1_COMPA_vect" && $4 > 25 || $2 == "USART_UDRE_vect" { ++seen }
    END { exit seen != 3 }' "$folder/first/interrupts_lever.csv" || fail "the lever's interrupts are not there"

refuses() { # PATTERN ARGUMENT...
    local pattern=$1 status=0
    shift
    "$fixbench" profile "$@" >"$folder/out" 2>"$folder/err" || status=$?
    [ "$status" -ne 0 ] || fail "accepted: $*"
    [ "$(grep -vc '^profile[: ]' "$folder/err")" -eq 1 ] || fail "not one line for: $*"
    grep -q -- "$pattern" "$folder/err" || fail "not a word of '$pattern' for: $*"
    [ ! -s "$folder/out" ] || fail "printed a table for: $*"
}
refuses 'cannot be opened' "$folder/none.elf"
refuses 'not an ELF file' "$folder/table"
refuses 'more than 0' "$program" --seconds 0
refuses 'more than 0' "$program" --seconds nan
refuses 'a marker is a byte' "$program" --from 256
refuses 'GPIOR0 was not written 7' "$program" --from 7 --seconds 0.001
refuses "no scenario 'earthquake'" "$lever" --scenario earthquake
