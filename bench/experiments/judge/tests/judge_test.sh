#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A stranger's functions, formulas and pipes are judged; what is wrong gets one clear line.
# Usage: judge_test.sh FIXBENCH STRANGERS_ELF SCRATCH_FOLDER CC
set -u
fixbench=$1
elf=$2
scratch=$3
cc=$4
source=$(cd "$(dirname "$0")/.." && pwd)
results=$(cd "$source/../../../results" && pwd)
rm -rf "$scratch" && mkdir -p "$scratch"
failures=0

fail() { echo "FAILED: $*"; failures=$((failures + 1)); }

# ends STATUS TEXT ARGUMENTS...: exits with the status, and stderr is one line that holds TEXT, or
# nothing where TEXT is empty.
ends() {
    local wanted=$1 text=$2 status=0
    shift 2
    "$fixbench" "$@" >"$scratch/out" 2>"$scratch/err" || status=$?
    [ $status -eq "$wanted" ] || fail "fixbench $*: exit $status: $(cat "$scratch/err")"
    if [ -z "$text" ]; then
        [ ! -s "$scratch/err" ] || fail "fixbench $*: said $(cat "$scratch/err")"
    else
        [ "$(wc -l <"$scratch/err")" -eq 1 ] || fail "fixbench $*: not one line: $(cat "$scratch/err")"
        grep -qF -- "$text" "$scratch/err" || fail "fixbench $*: no '$text' in: $(cat "$scratch/err")"
    fi
}
# value COLUMN OPERANDS: of the table printed last, which is CSV.
value() {
    python3 -c 'import csv, sys
print(*[row[sys.argv[2]] for row in csv.DictReader(open(sys.argv[1])) if row["operands"] == sys.argv[3]])' \
        "$scratch/out" "$1" "$2"
}
few=(--csv --samples 300)

ends 0 "" judge "$elf" --function my_sqrt --as sqrt:q16_16 "${few[@]}"
[ "$(value violations full)" = 0 ] && [ "$(value samples full)" = 300 ] || fail "my_sqrt: $(cat "$scratch/out")"
python3 - "$(value max_ulp uniform)" <<'P' || fail "the error of my_sqrt: $(cat "$scratch/out")"
import sys
sys.exit(not 0.4 < float(sys.argv[1]) <= 0.5)
P
# A product that truncates is off by just below an ulp, and never above the exact one.
product='int32(int32,int32)=a*b/2^16'
ends 0 "" judge "$elf" --function multiply --as "$product" --bound 1 "${few[@]}"
python3 - "$(value max_ulp full)" "$(value mean_ulp full)" <<'P' || fail "the error of multiply: $(cat "$scratch/out")"
import sys
sys.exit(not (0.9 < float(sys.argv[1]) < 1 and -0.6 < float(sys.argv[2]) < -0.3))
P
[ "$(value excluded uniform)" -gt 0 ] || fail "products that do not fit are judged"
ends 0 "" judge "$elf" --function multiply --as "int32(int32,int32)=floor(a*b/2^16)" --bound 0 "${few[@]}"
ends 1 "" judge "$elf" --function multiply --as "$product" "${few[@]}"
[ "$(value violations full)" -gt 0 ] && [ -n "$(value first_violation full)" ] || fail "no violation of multiply"
ends 0 "" judge "$elf" --function average --as 'uint16(uint16,uint16)=(a+b)/2' "${few[@]}"
[ "$(value violations full)" = 0 ] && [ "$(value max_ulp uniform)" = 0.5 ] || fail "average: $(cat "$scratch/out")"
ends 0 "" judge "$elf" --function half --as 'int16(int16)=floor(a/2)' "${few[@]}"
[ "$(value samples all)" = 65536 ] && [ "$(value bound all)" = exact ] || fail "half: $(cat "$scratch/out")"
ends 0 "" judge "$elf" --function half --as 'q8_8(q8_8)=a/2' --json
python3 -m json.tool "$scratch/out" >/dev/null || fail "--json is no JSON"

ends 0 "" judge "$elf" --function filter::third --as 'int16(int16)=trunc(a/3)' --bound 0 "${few[@]}"
ends 2 "several functions filter::twice: name one of _Z" judge "$elf" --function filter::twice --as 'int16(int16)=2*a'

identity='int32(int32)=a'
ends 1 "not done after" judge "$elf" --function hangs --as "$identity"
[ ! -s "$scratch/out" ] || fail "a function that hangs has figures"
ends 1 "r9 is changed" judge "$elf" --function clobbers --as "$identity"
ends 1 "outside of its stack frame" judge "$elf" --function strays --as "$identity"
ends 1 "registers that hold no operand" judge "$elf" --function three --as 'int32(int32,int32)=a+b'
ends 1 "returns less than the claim" judge "$elf" --function half --as 'int32(int32)=a/2'
ends 2 "did you mean my_sqrt" judge "$elf" --function my_sqr --as sqrt:q16_16
ends 2 "unknown operation 'root'" judge "$elf" --function half --as root:q16_16
ends 2 "unknown number format 'q7_1x'" judge "$elf" --function half --as sqrt:q7_1x
ends 2 "at character 3" judge "$elf" --function half --as 'int16(int16)=a+b'
ends 2 "a formula cannot use float" judge "$elf" --function half --as 'float(int16)=a'
ends 2 "<type>(<type>,...)=<formula>" judge "$elf" --function half --as 'int16=a'
ends 2 "--pipe" judge --as sqrt:q16_16
ends 2 "did you mean boundary" operands --as sqrt:q16_16 --class bondary
ends 2 "at most 32 bits" operands --as divide:q8_24 --class all
ends 2 "--operation" operands

# Pipes: in Python, in C, and lines that are wrong.
"$cc" -O2 "$source/examples/answer.c" -o "$scratch/answer" || fail "answer.c does not compile"
for class in boundary uniform; do
    "$fixbench" operands --operation divide --format q8_24 --class $class --samples 20000 |
        "$source/examples/answer.py" >"$scratch/divisions"
    ends 0 "" judge --pipe --as divide:q8_24 --csv <"$scratch/divisions"
    [ "$(value samples "")" = "$(wc -l <"$scratch/divisions")" ] || fail "lines are lost: $(cat "$scratch/out")"
    "$fixbench" operands --operation sqrt --format q16_16 --class $class | "$scratch/answer" |
        "$fixbench" judge --pipe --as sqrt:q16_16 >/dev/null || fail "answer.c, $class"
done
# A million results a second: of a processor's time, since others may use it too.
"$fixbench" operands --operation sqrt --format q16_16 --class uniform --samples 1000000 | "$scratch/answer" >"$scratch/million"
is_fast() {
    python3 - "$fixbench" "$@" <<'P' || fail "the pipe is slow: $2"
import resource, subprocess, sys
subprocess.run([sys.argv[1], "judge", "--pipe", "--as", *sys.argv[3:]], stdin=open(sys.argv[2]), stdout=subprocess.DEVNULL, check=True)
sys.exit(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime > 1)
P
}
is_fast "$scratch/million" sqrt:q16_16
# What is right in one format is wrong in another, and as quick to judge.
is_fast "$scratch/million" sqrt:q12_20 --bound 1e18
is_fast "$scratch/million" 'int32(int32)=a*3/2^16' --bound 1e18
sed '1000s/\(.*\) .*/\1 7/' "$scratch/divisions" >"$scratch/wrong"
ends 1 "" judge --pipe --as divide:q8_24 --csv <"$scratch/wrong"
[ "$(value violations "")" = 1 ] || fail "one wrong result of many: $(cat "$scratch/out")"
[ "$(value first_violation "")" = "$(sed -n '1000s/\(.*\) .*/\1/p' "$scratch/wrong")" ] || fail "the wrong result's operands"
lines() { printf "$1" >"$scratch/lines"; }
lines '# nothing\n\n'
ends 2 "no results" judge --pipe --as divide:q8_24 <"$scratch/lines"
lines '1 2 3\n1 2\n'
ends 2 "line 2: expected 2 operands and 1 results, got 2 numbers" judge --pipe --as divide:q8_24 <"$scratch/lines"
lines '1 x 3\n'
ends 2 "line 1: not decimal numbers" judge --pipe --as divide:q8_24 <"$scratch/lines"
lines '1 2 2147483648\n'
ends 2 "2147483648 is not in -2147483648..2147483647" judge --pipe --as divide:q8_24 <"$scratch/lines"
lines '1 65535 32768\n'
ends 0 "" judge --pipe --as 'uint16(uint16,uint16)=(a+b)/2' --csv <"$scratch/lines"
[ "$(value max_ulp_witness "")" = "1 65535" ] || fail "an unsigned witness: $(cat "$scratch/out")"
lines '100 -3 4\n100 2000000000 0\n-100 2 -400\n'
ends 0 "" judge --pipe --as shift_left:q16_16 --csv <"$scratch/lines"
[ "$(value excluded "")" = 2 ] && [ "$(value violations "")" = 0 ] || fail "shifts: $(cat "$scratch/out")"
lines '65536 16777216 65536' # the last line has no end
ends 0 "" judge --pipe --as divide:q8_24 --csv <"$scratch/lines"

# The committed corpora are those of the committed data, and every implementation can be held to them.
"$fixbench" corpus --data "$results/data" --output "$scratch/corpus" || fail "corpus"
diff -r "$results/corpus" "$scratch/corpus" >/dev/null ||
    fail "results/corpus is not what \`fixbench corpus --data results/data --output results/corpus\` writes"
"$scratch/answer" <"$results/corpus/sqrt_q16_16.txt" | "$fixbench" judge --pipe --as sqrt:q16_16 >/dev/null ||
    fail "the corpus of sqrt"
exit $((failures != 0))
