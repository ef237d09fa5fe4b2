#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What a user sees of fixbench: good calls print or write what was asked for, bad ones get one clear
# line and exit with 2. Usage: command_line_test.sh FIXBENCH SCRATCH_FOLDER
set -u
fixbench=$1
scratch=$2
source=$(cd "$(dirname "$0")/../.." && pwd)
rm -rf "$scratch" && mkdir -p "$scratch"
failures=0

fail() { echo "FAILED: $*"; failures=$((failures + 1)); }

# refuses TEXT ARGUMENTS...: exits with 2 and one line on stderr that holds TEXT, prints nothing.
refuses() {
    local text=$1 status=0
    shift
    "$fixbench" "$@" >"$scratch/out" 2>"$scratch/err" </dev/null || status=$?
    [ $status -eq 2 ] || fail "fixbench $*: exit $status"
    [ "$(wc -l <"$scratch/err")" -eq 1 ] || fail "fixbench $*: not one line: $(cat "$scratch/err")"
    [ ! -s "$scratch/out" ] || fail "fixbench $*: printed $(head -3 "$scratch/out")"
    grep -qF -- "$text" "$scratch/err" || fail "fixbench $*: no '$text' in: $(cat "$scratch/err")"
}

refuses "subcommand" # nothing asked for
refuses "frobnicate" frobnicate
refuses "--frobnicate" cycles --frobnicate

# Every name is held against those that exist, the good beside a bad one too.
a=(--output "$scratch/a")
refuses "did you mean multiply" cycles --operation multiplt "${a[@]}"
refuses "'q7_1'" cycles --format q16_16,q7_1 "${a[@]}"
refuses "did you mean libc" cycles --implementation lbc "${a[@]}"
refuses "boundary, full, physics, published, small" cycles --operands huge "${a[@]}"
refuses "atmega1284p, atmega2560, atmega32u4, attiny85" cycles --mcu attiny13 "${a[@]}"
refuses "did you mean atmega2560" cycles --mcu atmega256 "${a[@]}"
refuses "q16_16, q32_32" cycles --mcu attiny85 --format float "${a[@]}"
refuses "boundary, full, physics" cycles --mcu attiny85 --operands small "${a[@]}"
refuses "'q7_1'" accuracy --format q7_1 "${a[@]}"
refuses "did you mean default" verify --implementation defualt "${a[@]}"
refuses "selected" verify --operation add --format float "${a[@]}"
refuses "did you mean pendulum" scenes --scene pendulun "${a[@]}"
refuses "did you mean q16_16" scenes --scene pendulum --scalar q16_61 "${a[@]}"
refuses "velocity_verlet" scenes --method verlet "${a[@]}"
refuses "did you mean spring_stiffness" stability --case spring_stifness "${a[@]}"
refuses "allowed are" stability --scalar q7_1 "${a[@]}"
refuses "allowed are" stability --integrator leapfrog "${a[@]}"
refuses "did you mean bounce" haptic --scenario bonce "${a[@]}"
refuses "float, published, q16_16" haptic --arithmetic double "${a[@]}"
refuses "did you mean lever" features --scene levr "${a[@]}"
refuses "did you mean sqrt_q16_16_default" exhaustive --symbol sqrt_q16_16_defalt "${a[@]}"

# So are numbers.
for samples in 0 -1 nan 1e3x 99999999999999; do
    refuses "--samples" cycles --samples "$samples" "${a[@]}"
    refuses "--samples" verify --samples "$samples" "${a[@]}"
done
refuses "--search-operands" exhaustive --search-operands -1 "${a[@]}"
refuses "--threads" accuracy --threads 0 "${a[@]}"
refuses "--seconds" haptic --seconds 0 "${a[@]}"
refuses "--most" growth --host --most 20000 "${a[@]}"
refuses "--seconds" throughput --seconds 0 "${a[@]}"
for error in nan -1 0 inf x; do refuses "--error" advise --scene pendulum --error "$error"; done
refuses "--lines" advise --scene pendulum --error 1 --lines 0

refuses "takes no --program" cycles --mcu attiny85 --program "$fixbench" "${a[@]}"
refuses "neither a folder nor a git revision" compare no-such-revision "$source/results"
refuses "holds neither operations.csv" compare "$source/results" "$source/scripts"
refuses "is required" compare "$source/results"
"$fixbench" compare "$source/results" "$source/results" --csv 2>/dev/null | grep -q "^score,.*geometric mean" ||
    fail "a run is worse than itself"

refuses "does not exist" cycles --program "$scratch/absent.elf"
echo "not an ELF" >"$scratch/text.elf"
refuses "text.elf" cycles --program "$scratch/text.elf" "${a[@]}"
[ -e "$scratch/a" ] && fail "a refused run has written files"
: >"$scratch/file"
one=(cycles --operation multiply --format q16_16 --implementation default --operands physics --samples 10)
for command in cycles table accuracy verify throughput blocks features growth scenes workload stability haptic region; do
    refuses "cannot write" $command --output "$scratch/file/below"
done
refuses "cannot write" "${one[@]}" --output "$scratch/file/below"
refuses "cannot write" profile "$(dirname "$fixbench")/device/q8_8.elf" --output "$scratch/file/below"
status=0
"$fixbench" report --results "$scratch/absent" 2>"$scratch/err" || status=$?
[ $status -ne 0 ] && grep -q 'missing; `fixbench all --only cycles` writes it' "$scratch/err" ||
    fail "report does not say who makes what is missing: $(tail -1 "$scratch/err")"

for command in cycles accuracy table verify report; do
    "$fixbench" $command --help | grep -q "Example\|Files\|Figures" || fail "$command --help teaches nothing"
done
"$fixbench" --help | grep -q "Exit status" || fail "--help says nothing of exit codes"
[[ $("$fixbench" --version) =~ ^fixbench\ [0-9]+\.[0-9]+ ]] || fail "--version"

# Without --output the table is printed, and the results stay as they are.
before=$(cd "$source/results" && find . -type f -exec sha256sum {} + | sort | sha256sum)
(cd "$source" && "$fixbench" "${one[@]}" >"$scratch/printed" 2>/dev/null) || fail "cycles, printed"
[ "$(wc -l <"$scratch/printed")" = 2 ] && head -1 "$scratch/printed" | grep -q "^operation *format" || fail "no table is printed"
(cd "$source" && "$fixbench" "${one[@]}" --json 2>/dev/null) | python3 -m json.tool >/dev/null || fail "--json is no JSON"
(cd "$source" && "$fixbench" "${one[@]}" --csv 2>/dev/null) >"$scratch/csv"
after=$(cd "$source/results" && find . -type f -exec sha256sum {} + | sort | sha256sum)
[ "$before" = "$after" ] || fail "a run without --output changed results/"

"$fixbench" "${one[@]}" --output "$scratch/good" 2>/dev/null || fail "cycles"
cmp -s "$scratch/csv" "$scratch/good/operations.csv" || fail "printed and written tables differ"
[ "$(wc -l <"$scratch/good/operations.csv")" = 2 ] || fail "operations.csv has more than one row"
head -1 "$scratch/good/operations.csv" | grep -q "^operation,format,implementation,operands,samples,regular,cycles_min,cycles_mean,cycles_max,cycles_max_witness,max_ulp,max_ulp_witness,rms_ulp,flash_bytes,stack_bytes" ||
    fail "the columns of operations.csv"
python3 -m json.tool "$scratch/good/operations.json" >/dev/null || fail "operations.json is no JSON"
# A selection never replaces what is there.
refuses "operations.csv already exists" "${one[@]}" --output "$scratch/good"

# A subject that misbehaves is named with its operands, and all others are measured.
"$fixbench" cycles --program "$(dirname "$fixbench")/experiments/operations/misbehaving.elf" --operands boundary \
    --csv >"$scratch/out" 2>"$scratch/err"
[ $? -eq 1 ] || fail "cycles of subjects that misbehave: exit status"
grep -q "negate_q8_8_hangs: boundary operands: not done .* with the operands 256" "$scratch/err" ||
    fail "a subject that hangs: $(cat "$scratch/err")"
[ "$(grep -c ^negate,q8_8 "$scratch/out")" -eq 3 ] || fail "good subjects beside bad ones: $(cat "$scratch/out")"

# Rows of whole input spaces are kept only where they are of this code.
sqrt=(accuracy --operation sqrt --format q16_16 --implementation default --keep)
"$fixbench" "${sqrt[@]}" "$source/results/data" --csv >"$scratch/kept" 2>"$scratch/err" ||
    fail "accuracy --keep: $(cat "$scratch/err")"
grep -qxF "$(tail -1 "$scratch/kept")" "$source/results/data/accuracy.csv" || fail "the row that is kept is another"
mkdir "$scratch/stale"
cp "$source"/results/data/{accuracy,error_histograms}.csv "$scratch/stale"
sed -i '/^sqrt,q16_16,default/s/,0\.5,/,0.25,/' "$scratch/stale/accuracy.csv"
"$fixbench" "${sqrt[@]}" "$scratch/stale" >/dev/null 2>"$scratch/err"
[ $? -eq 2 ] && grep -q "is not of this code" "$scratch/err" || fail "a stale row is kept: $(cat "$scratch/err")"
sed -i '/^sqrt,q16_16,default/d' "$scratch/stale/accuracy.csv"
"$fixbench" "${sqrt[@]}" "$scratch/stale" --csv >"$scratch/kept" 2>"$scratch/err" || fail "accuracy without a row to keep"
grep -q "sampled, since .* holds no row" "$scratch/err" || fail "a row that is not kept is silent: $(cat "$scratch/err")"
grep -q '"boundary, random, search"' "$scratch/kept" || fail "a sample is told as all inputs: $(cat "$scratch/kept")"

# Without measured cycles, advice says so.
"$fixbench" advise --scene free_fall --error 10 --data "$scratch" >"$scratch/out" 2>"$scratch/err"
grep -q "scenes.csv is missing" "$scratch/err" || fail "advise without data is silent"
# What no data file has the cycles of is measured, or the reason why not stands in their place. The
# command is the README's.
advise=$(grep -om1 "fixbench advise --scene .*" "$source/README.md") || fail "the README gives no advice"
read -ra advise <<<"${advise#fixbench}"
"$fixbench" "${advise[@]}" --data "$source/results/data" >"$scratch/out" 2>"$scratch/err" ||
    fail "${advise[*]}: exit $?: $(tail -1 "$scratch/err")"
awk '$3 ~ /^2\^-/ && $5 !~ /^[0-9]+$/ && !/exceeds the flash/ { bad = 1 } END { exit bad }' \
    "$scratch/out" || fail "advise leaves cycles unmeasured: $(cat "$scratch/out")"
grep -q '^Q' "$scratch/out" || fail "advise names no format: $(cat "$scratch/out")"

[ $failures -eq 0 ] && echo "command line: all as documented"
exit $((failures != 0))
