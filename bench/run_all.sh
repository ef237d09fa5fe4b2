#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Measures everything and writes results/: sets up, builds, runs every bench, draws the report.
#
# Usage: bench/run_all.sh [--quick | --full | --exhaustive] [--check] [--help]
#   --full   every input space exhausted, all samples, the search over hypotheses, an hour of the
#            lever, and four minutes of fuzzing (default); writes results/
#   --quick  the same benches on fewer operands, some minutes after the build; writes
#            build/quick/ and leaves results/ alone
#   --exhaustive  only the kernels as machine code, over all inputs or 10^9 of them: an hour on two
#            cores; writes results/data/exhaustive.csv, which the other modes leave as it is, and
#            draws the report anew
#   --check  measures into build/check/ instead and fails where a deterministic figure (cycles,
#            sizes, errors, hashes) differs from the committed results/
set -euo pipefail
cd "$(dirname "$0")/.."

mode=full check=
for argument in "$@"; do
    case $argument in
        --quick) mode=quick ;;
        --full) mode=full ;;
        --exhaustive) mode=exhaustive ;;
        --check) check=yes ;;
        --help) sed -n '3,/^set /{/^set /d;s/^# \{0,1\}//p}' "$0"; exit 0 ;;
        *) echo "run_all.sh: unknown argument '$argument'; see --help" >&2; exit 2 ;;
    esac
done
if [ "$mode" != full ] && [ -n "$check" ]; then
    echo "run_all.sh: --check compares full results; it does not go with --$mode" >&2
    exit 2
fi

results=results
[ "$mode" = quick ] && results=build/quick
[ -n "$check" ] && results=build/check
data=$results/data

fuzzing=
if [ "$mode" = full ] && [ -z "$check" ]; then
    fuzzing=yes
    scripts/setup.sh --fuzz
fi
scripts/build.sh release
bin=build/release/bench
fixbench=$bin/fixbench
firmware=build/release/firmware
mkdir -p "$data"

if [ "$mode" = exhaustive ]; then
    for program in q4_4 q8_8 q16_16 q32_32; do
        "$fixbench" exhaustive --program "$bin/device/$program.elf" --output "$data"
    done
    "$fixbench" report --results "$results"
    exit 0
fi

quick=() samples=20000 verified=1000000 repetitions=0.2 most=4096 seconds=()
if [ "$mode" = quick ]; then
    quick=(--quick) samples=1000 verified=2000 repetitions=0.02 most=64 seconds=(--seconds 30)
fi
"$fixbench" cycles --samples "$samples" --output "$data"
"$fixbench" table "${quick[@]}" --output "$data"
"$fixbench" verify --samples "$verified" --output "$data"
"$fixbench" accuracy "${quick[@]}" --output "$data"
"$bin/operations/host_throughput" --benchmark_min_time="$repetitions" \
    --benchmark_out="$data/host_throughput.json.partial" --benchmark_out_format=json >&2
mv "$data/host_throughput.json.partial" "$data/host_throughput.json"
"$fixbench" features --output "$data" >&2
"$fixbench" growth --output "$data" >&2
"$fixbench" growth --host --most "$most" --output "$data" >&2
"$fixbench" scenes "${quick[@]}" --output "$data"
"$fixbench" workload --output "$data"
"$fixbench" stability "${quick[@]}" --output "$data"
header=firmware/src/firmware/calibration_table.hpp
[ "$results" = results ] || header=$data/calibration_table.hpp
"$fixbench" calibrate reference/published/table_d_1.csv --output "$data" --header "$header" >&2
"$fixbench" haptic "${seconds[@]}" --output "$data"
"$fixbench" region "${quick[@]}" --output "$data"
"$fixbench" profile "$firmware/lever.elf" --scenario poke_while_held --seconds 5 --output "$data" \
    --figures "$results/figures" >&2
"$fixbench" lever --scenario demonstration --record "$data" >&2
"$fixbench" report --results "$results"

[ -z "$fuzzing" ] || cmake --build build/release --target fuzz >&2

if [ -n "$check" ]; then
    # Times of the host differ from run to run, and the exhaustive runs are a mode of their own;
    # everything else is a function of the toolchain.
    measured_elsewhere=(--exclude=host_throughput.json --exclude=growth_host.csv
                        --exclude=exhaustive.csv --exclude=calibration_table.hpp)
    if ! diff -r --brief "${measured_elsewhere[@]}" results/data "$data" >&2; then
        diff -r "${measured_elsewhere[@]}" results/data "$data" | head -40 >&2
        echo "run_all.sh: deterministic figures differ from results/data" >&2
        exit 1
    fi
    echo "run_all.sh: every deterministic figure equals results/data" >&2
else
    echo "run_all.sh: wrote $results/README.md" >&2
fi
