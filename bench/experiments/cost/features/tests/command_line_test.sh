#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# command_line_test.sh FIXBENCH FOLDER: what `fixbench features` writes.
set -euo pipefail
fixbench=$1 folder=$2
rm -rf "$folder"
mkdir -p "$folder"
fail() { echo "$*" >&2; exit 1; }

"$fixbench" features --output "$folder" 2>/dev/null
[ "$("$fixbench" features --csv 2>/dev/null | sha256sum)" = "$(sha256sum <"$folder/features.csv")" ] ||
    fail "printed and written tables differ"
# A feature costs flash, and what it costs is as said by the two rows beside each other.
awk -F, 'NR > 1 && $2 !~ /=/ { flash[$1 "," $2 "," $3] = $4 }
    END {
        for (key in flash) {
            if (key !~ /,no$/) continue
            with = key
            sub(/,no$/, ",yes", with)
            if (!(flash[with] > flash[key])) { print key, "takes no flash"; exit 1 }
        }
    }' "$folder/features.csv"
# Every method that the engine's README lists has a row.
readme=$(dirname "$0")/../../../../../engine/README.md
methods=$(sed -n '/^## Which method/,/^There is/s/^| \([^|]*\) |.*/\1/p' "$readme" | grep -o '[A-Z][A-Za-z]*')
[ "$(wc -w <<<"$methods")" -ge 14 ] || fail "the README lists too few methods: $methods"
for method in $methods CompensatedIntegration ContinuousContacts; do
    grep -q "=${method}[<,]" "$folder/features.csv" || fail "no row of $method"
done
# One line and no file where there is no such folder.
status=0
"$fixbench" features --output "$folder/features.csv/none" >/dev/null 2>"$folder/err" || status=$?
[ "$status" -ne 0 ] || fail "accepted a folder that cannot be"
[ "$(grep -vc '^features[: ]' "$folder/err")" -eq 1 ] || fail "not one line"
