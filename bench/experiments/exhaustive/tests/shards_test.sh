#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Shards on several workers, of which one is killed on the way, merge to the very bytes of one run:
# by the line for GNU parallel that the help shows, and by the script for Slurm.
# Usage: shards_test.sh FIXBENCH FUNCTIONS_ELF SCRATCH_FOLDER
set -u
fixbench=$1
elf=$2
scratch=$3
source=$(cd "$(dirname "$0")/.." && pwd)
rm -rf "$scratch" && mkdir -p "$scratch/bin"
failures=0

fail() { echo "FAILED: $*"; failures=$((failures + 1)); }

shards=3
# The first function is done at once and leaves its checkpoint; the second takes a second a worker.
run=(--program "$elf" --symbol "multiply_q4_4_default,add_q32_32_default" --search-operands 3000000)
victim=exhaustive.multiply_q4_4_default.2-of-$shards.checkpoint.json

# kill_amid FOLDER: kills the worker of the second shard, whose process number is in FOLDER/worker,
# as soon as one of its two functions is done. Says so in FOLDER/killed.
kill_amid() {
    local i
    for ((i = 0; i < 3000; i++)); do
        if [ -e "$1/$victim" ]; then
            kill -KILL "$(cat "$1/worker")" && touch "$1/killed"
            return
        fi
        sleep 0.01
    done
}
# is_merged FOLDER: the shards' files in it make what one run makes.
is_merged() {
    [ -e "$1/killed" ] || fail "$1: no worker was killed on its way"
    "$fixbench" merge --output "$1" "$1"/*.json || fail "$1: merge"
    cmp "$1/exhaustive.csv" "$scratch/whole/exhaustive.csv" || fail "$1: not the bytes of one run"
}

"$fixbench" exhaustive --output "$scratch/whole" "${run[@]}" 2>/dev/null || fail "one run"

# GNU parallel: the line of the help, in which our `fixbench` is the program with this test's options.
cat >"$scratch/bin/fixbench" <<W
#!/bin/sh
case "\$*" in *" 2/$shards"*) echo \$\$ >"$scratch/parallel/worker" ;; esac
echo "\$*" >>"$scratch/calls"
exec "$fixbench" "\$@" --threads 1 $(printf "'%s' " "${run[@]}")
W
chmod +x "$scratch/bin/fixbench"
mkdir "$scratch/parallel"
line=$("$fixbench" exhaustive --help | sed -n "s/^ *\(parallel .*\)/\1/p" | sed "s|DIR|$scratch/parallel|; s/16/$shards/g")
[ -n "$line" ] || fail "the help shows no line for parallel"
kill_amid "$scratch/parallel" &
PATH="$scratch/bin:$PATH" bash -c "$line" >/dev/null 2>"$scratch/err" || fail "$line: $(cat "$scratch/err")"
wait
[ "$(grep -c " 2/$shards" "$scratch/calls")" = 2 ] && [ "$(wc -l <"$scratch/calls")" = $((shards + 1)) ] ||
    fail "parallel made other calls: $(cat "$scratch/calls")"
is_merged "$scratch/parallel"

# Slurm: each task is a shell of its own. The killed one is submitted again, alone.
slurm() { SLURM_ARRAY_TASK_ID=$1 "$source/slurm.sh" $shards "$fixbench" --output "$scratch/slurm" "${run[@]}" 2>/dev/null; }
mkdir "$scratch/slurm"
slurm 1 & first=$!
(echo "$BASHPID" >"$scratch/slurm/worker" && SLURM_ARRAY_TASK_ID=2 exec "$source/slurm.sh" $shards "$fixbench" \
    --output "$scratch/slurm" "${run[@]}" 2>/dev/null) & second=$!
kill_amid "$scratch/slurm"
wait $first || fail "the first task"
wait $second && fail "the killed task succeeds"
slurm 3 || fail "the third task"
"$fixbench" merge --output "$scratch/early" "$scratch"/slurm/exhaustive.*-of-$shards.json 2>"$scratch/err" && fail "a merge without a shard"
grep -q "the shards hold" "$scratch/err" || fail "a merge without a shard says $(cat "$scratch/err")"
slurm 2 || fail "the task that is submitted again"
is_merged "$scratch/slurm"

# refuses TEXT COMMAND...: one line that holds TEXT, and exit status 2.
refuses() {
    local text=$1 status=0
    shift
    "$@" 2>"$scratch/err" || status=$?
    [ $status -eq 2 ] && [ "$(wc -l <"$scratch/err")" = 1 ] && grep -qF -- "$text" "$scratch/err" ||
        fail "$*: exit $status: $(cat "$scratch/err")"
}
unset SLURM_ARRAY_TASK_ID
refuses "the number of shards" "$source/slurm.sh" 3
refuses "sbatch --array=1-3" "$source/slurm.sh" 3 "$fixbench" --output "$scratch"
refuses "shard '4/3'" env SLURM_ARRAY_TASK_ID=4 "$source/slurm.sh" 3 "$fixbench" --output "$scratch" "${run[@]}"
exit $((failures != 0))
