#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# command_line_test.sh FIXBENCH FOLDER: what `fixbench growth` writes and refuses.
set -euo pipefail
fixbench=$1 folder=$2
rm -rf "$folder"
mkdir -p "$folder"
fail() { echo "$*" >&2; exit 1; }

"$fixbench" growth --output "$folder" 2>/dev/null
# Both broad phases, more cycles and more memory for more particles, the cheapest of each pair named.
awk -F, 'NR > 1 {
        if ($2 == search && !($4 > cost && $7 > ram)) { print "not growing: " $0; exit 1 }
        if ($2 == "brute_force" ? $6 != $3 * ($3 - 1) / 2 : $6 > $3 * ($3 - 1) / 2) { print "not the pairs: " $0; exit 1 }
        search = $2; cost = $4; ram = $7; searches[$2]++; cheapest[$3] += $16 == "yes"
    }
    END {
        if (searches["brute_force"] < 8 || searches["brute_force"] != searches["sort_and_sweep"]) exit 1
        for (n in cheapest) if (cheapest[n] != 1) { print n " particles: no cheapest"; exit 1 }
    }' "$folder/growth.csv" || fail "growth.csv is not as it should be"
"$fixbench" growth --host --most 144 --rounds 2 --output "$folder" 2>/dev/null
[ "$(wc -l <"$folder/growth_host.csv")" -eq 13 ] || fail "growth_host.csv has not three rows for each of 16, 36, 64, 144"
# Ours are counted, Box2D's are not.
awk -F, 'NR > 1 && ($2 == "box2d" ? $6 $11 != "" : !($6 > 0 && $11 > 0 &&
        ($2 != "brute_force" || $6 == $3 * ($3 - 1) / 2))) { exit 1 }' \
    "$folder/growth_host.csv" || fail "growth_host.csv has not what was counted"
# What the help says of the exit status.
"$fixbench" growth --help | tr '\n' ' ' | grep -q 'with 1 where a cost on the chip .*; with --host that is reported only' ||
    fail "the help does not say where a miss is reported only"
status=0
"$fixbench" growth --host --most 16385 >/dev/null 2>"$folder/err" || status=$?
[ "$status" -ne 0 ] || fail "accepted 16385 particles"
