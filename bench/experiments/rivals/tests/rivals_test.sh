#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Rivals are measured, from a checkout and without; figures of the last run stay.
# Usage: rivals_test.sh FIXBENCH SCRATCH_FOLDER
set -u
fixbench=$1
scratch=$2
results=$(cd "$(dirname "$0")/../../../../results" && pwd)
rm -rf "$scratch" && mkdir -p "$scratch"
failures=0

fail() { echo "FAILED: $*"; failures=$((failures + 1)); }

refuses() {
    local text=$1 status=0
    shift
    "$fixbench" rivals "$@" >"$scratch/out" 2>"$scratch/err" || status=$?
    [ $status -eq 2 ] || fail "rivals $*: exit $status"
    [ "$(wc -l <"$scratch/err")" -eq 1 ] || fail "rivals $*: not one line: $(cat "$scratch/err")"
    grep -qF -- "$text" "$scratch/err" || fail "rivals $*: no '$text' in: $(cat "$scratch/err")"
}
refuses "did you mean libfixmath" --source libfixmat=.
refuses "<rival>=<folder>" --source libfixmath
refuses "the folder must exist" --source "libfixmath=$scratch/absent"
mkdir "$scratch/empty"
refuses "is not a checkout of" --source "libfixmath=$scratch/empty"
refuses "fp64_*.S is missing" --source "fp64lib=$scratch/empty"
mkdir "$scratch/broken"
echo "#error broken" >"$scratch/broken/fixedptc.h"
refuses "fixedptc: avr-gcc fails" --source "fixedptc=$scratch/broken"

# Nothing is lost of the last run, and what is measured again is the same.
"$fixbench" rivals --keep "$results/data/rivals.csv" --output "$scratch/kept" 2>/dev/null || fail "rivals"
cmp -s "$scratch/kept/rivals.csv" "$results/data/rivals.csv" ||
    fail "rivals.csv differs: $(diff "$scratch/kept/rivals.csv" "$results/data/rivals.csv" | head -3)"

# A library of the test's own: the product rounds to nearest, the quotient truncates, the root hangs.
mkdir "$scratch/own"
cat >"$scratch/own/fixedptc.h" <<'H'
#include <stdint.h>
#define F (32 - FIXEDPT_WBITS)
#define fixedpt_add(a, b) ((a) + (b))
#define fixedpt_sub(a, b) ((a) - (b))
static int32_t fixedpt_mul(int32_t a, int32_t b) { return ((int64_t)a * b + (1L << (F - 1))) >> F; }
static int32_t fixedpt_div(int32_t a, int32_t b) { return b ? ((int64_t)a << F) / b : 77; }
static int32_t fixedpt_sqrt(int32_t a) { for (;;) __asm__ volatile(""); return a; }
#define fixedpt_sin(a) (a)
#define fixedpt_cos(a) (a)
#define fixedpt_exp(a) (a)
#define fixedpt_ln(a) (a)
H
"$fixbench" rivals --source "fixedptc=$scratch/own" --samples 300 --output "$scratch/built" 2>/dev/null || fail "a library of our own"
python3 - "$scratch/built/rivals.csv" <<'P' || failures=$((failures + 1))
import csv, sys
rows = {(row["variant"], row["operation"], row["format"], row["operands"]): row for row in csv.DictReader(open(sys.argv[1]))}
product = rows["fixedptc", "multiply", "q16_16", "physics"]
assert 0.49 < float(product["max_ulp"]) <= 0.5 and product["within_half_ulp"] == "1", product
assert abs(float(product["max_error"]) * 2**16 - float(product["max_ulp"])) < 1e-5, product
assert int(product["flash_bytes"]) > 50 and int(product["cycles_min"]) > 50, product
quotient = rows["fixedptc", "divide", "q16_16", "physics"]
assert 0.9 < float(quotient["max_ulp"]) < 1, quotient
assert "1 / 0: 0.0011749" in quotient["edges"], quotient  # 77 / 2^16
root = rows["fixedptc", "sqrt", "q16_16", "physics"]
assert "not done" in root["failure"] and root["samples"] == "0" and root["cycles_mean"] == "", root
assert ("fixedptc_default", "multiply", "q24_8", "full") in rows and ("gcc_accum", "divide", "s16_15", "full") in rows
assert product["commit"] == "" and product["measured"]
P
exit $((failures != 0))
