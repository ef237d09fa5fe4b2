#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#SBATCH --job-name=exhaustive
#SBATCH --array=1-16
#SBATCH --cpus-per-task=1
#SBATCH --requeue
# A task of a Slurm array runs one shard of `fixbench exhaustive`. The folder of --output holds the
# checkpoints, so it must be on a file system that all nodes share: a task that is started again,
# by Slurm or by the same call, continues from its checkpoint.
#
# Usage: sbatch --array=1-SHARDS slurm.sh SHARDS FIXBENCH --output DIR --program ELF [OPTIONS]
#   SHARDS    the number of parts of the work. Slurm's own count would be wrong if only the tasks
#             that failed are submitted again (--array=3,7).
#   FIXBENCH  the program; what follows are options of `fixbench exhaustive`. Name the device
#             program, or else every node tries to build it.
# Then: fixbench merge --output DIR DIR/*.json
set -eu

if [ $# -lt 2 ]; then
    echo "slurm.sh: the number of shards and the program fixbench are missing; the head of this file says how to call it" >&2
    exit 2
fi
if [ -z "${SLURM_ARRAY_TASK_ID:-}" ]; then
    echo "slurm.sh: SLURM_ARRAY_TASK_ID is not set: submit it with \`sbatch --array=1-$1\`" >&2
    exit 2
fi
shards=$1
fixbench=$2
shift 2
exec "$fixbench" exhaustive --threads "${SLURM_CPUS_PER_TASK:-1}" --shard "$SLURM_ARRAY_TASK_ID/$shards" "$@"
