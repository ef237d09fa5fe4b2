#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# `fixbench all` on the cheapest experiments: what it writes, leaves out and survives.
# Usage: sequence_test.sh FIXBENCH SCRATCH_FOLDER
set -u
fixbench=$1
scratch=$2
rm -rf "$scratch" && mkdir -p "$scratch"
failures=0
fail() { echo "FAILED: $*"; failures=$((failures + 1)); }

# The list is one: all data files that are committed have a maker, and one only. The report's are
# bounds.csv, columns.json and, after a full run, tools.json: with what the others were measured.
"$fixbench" --list --json >"$scratch/list.json" || fail "--list --json"
/usr/bin/python3 - "$scratch/list.json" "$(dirname "$0")/../../results/data" <<'PYTHON' || fail "the list of experiments"
import collections, json, os, sys
experiments = json.load(open(sys.argv[1]))
made = collections.Counter(file for each in experiments for file in each["writes"] + each["full_only"])
twice = [file for file, count in made.items() if count > 1]
orphans = [file for file in os.listdir(sys.argv[2]) if file not in {*made, "bounds.csv", "columns.json", "tools.json"}]
sys.exit(f"made twice: {twice}; made by nobody: {orphans}" if twice or orphans else 0)
PYTHON
"$fixbench" --list | grep -q "^growth_host .*growth_host.csv" || fail "--list names what each writes"

refuses() {
    local text=$1 status=0
    shift
    "$fixbench" "$@" >"$scratch/out" 2>"$scratch/err" </dev/null || status=$?
    [ $status -eq 2 ] || fail "fixbench $*: exit $status"
    [ "$(wc -l <"$scratch/err")" -eq 1 ] || fail "fixbench $*: not one line: $(cat "$scratch/err")"
    grep -qF -- "$text" "$scratch/err" || fail "fixbench $*: no '$text' in: $(cat "$scratch/err")"
}
refuses "did you mean growth" all --quick --only growht
refuses "excludes" all --quick --check
refuses "leaves them out" all --check --only throughput --results "$scratch/none"
: >"$scratch/file"
refuses "cannot write" all --quick --only growth --results "$scratch/file/below"

# Two steps side by side; what is there afterwards is what they are registered to write.
"$fixbench" all --quick --only growth,lever --threads 2 --results "$scratch/results" 2>"$scratch/err" ||
    fail "all --only: $(cat "$scratch/err")"
[ "$(cd "$scratch/results/data" && echo *)" = "growth.csv lever.cast lever.svg replay.json" ] ||
    fail "all --only wrote $(ls "$scratch/results/data")"
grep -q "no report yet" "$scratch/err" || fail "says nothing of the report"
grep -q "broad\|cheaper" "$scratch/err" && fail "what the steps say is mixed into the progress"

# What is committed is what is measured, and nothing else is committed.
"$fixbench" all --check --only calibrate --results "$scratch/check" 2>"$scratch/err" || fail "--check: $(cat "$scratch/err")"
grep -q "all [0-9]* deterministic files equal" "$scratch/err" || fail "--check says nothing: $(cat "$scratch/err")"

# What has not changed is left out; what was touched is measured again, and comes out the same.
sum=$(sha256sum <"$scratch/results/data/growth.csv")
"$fixbench" all --quick --resume --only growth,lever --results "$scratch/results" 2>"$scratch/err" || fail "--resume"
grep -q "unchanged: .*growth" "$scratch/err" && grep -q "unchanged: .*lever" "$scratch/err" || fail "--resume ran again"
echo damaged >"$scratch/results/data/growth.csv"
"$fixbench" all --quick --resume --only growth,lever --results "$scratch/results" 2>"$scratch/err" || fail "--resume"
grep -q "^growth:" "$scratch/err" && ! grep -q "^lever:" "$scratch/err" || fail "--resume of one: $(cat "$scratch/err")"
[ "$(sha256sum <"$scratch/results/data/growth.csv")" = "$sum" ] || fail "measured again it differs"

# Interrupted, nothing is lost or half-written, no child goes on, and the run can be taken up.
"$fixbench" all --quick --only features,growth --threads 1 --results "$scratch/results" 2>"$scratch/err" &
pid=$!
children() { tr ' ' '\n' <"/proc/$pid/task/$pid/children" 2>/dev/null; }
# A child that measures is fixbench with another command. Another test's build may hold it up for long.
while kill -0 $pid 2>/dev/null; do
    for child in $(children); do
        [[ $(tr '\0' ' ' <"/proc/$child/cmdline") =~ fixbench\ (features|growth)\  ]] && break 2
    done 2>/dev/null
    sleep 0.1
done
sleep 0.3
kill -INT $pid
wait $pid
status=$?
[ $status -eq 130 ] || fail "interrupted: exit $status"
grep -q "interrupted; . of 2 steps are done" "$scratch/err" || fail "interrupted: $(cat "$scratch/err")"
[ "$(sha256sum <"$scratch/results/data/growth.csv")" = "$sum" ] || fail "an old file was harmed"
[ -z "$(find "$scratch/results" -name '*partial*' -o -name '*trial*')" ] || fail "half a file is left"
[ -e "/proc/$child" ] && fail "a child goes on"

# The shell and the manual know what the command line knows.
"$fixbench" completion >"$scratch/completion" && bash -n "$scratch/completion" || fail "the completion"
(
    . "$scratch/completion"
    COMP_WORDS=(fixbench cyc) COMP_CWORD=1
    _fixbench
    [ "${COMPREPLY[*]}" = cycles ] || exit 1
    COMP_WORDS=(fixbench all --res) COMP_CWORD=2
    _fixbench
    [ "${COMPREPLY[*]}" = "--results --resume" ] || [ "${COMPREPLY[*]}" = "--resume --results" ]
) || fail "completes wrongly"
"$fixbench" man >"$scratch/fixbench.1" || fail man
for text in '^\.TH FIXBENCH 1' '^\.SS cycles' 'EXIT STATUS' '\\-\\-exhaustive'; do
    grep -q -- "$text" "$scratch/fixbench.1" || fail "the manual page has no $text"
done

[ $failures -eq 0 ] && echo "sequence: all as documented"
exit $((failures != 0))
