#!/bin/sh
# A list of garments as a Slurm array of 100 tasks: sbatch slurm.sh LIST FOLDER; then sh slurm.sh --merge FOLDER
#SBATCH --array=1-100
#SBATCH --cpus-per-task=2
set -eu
if [ "$1" = --merge ]; then
    # every result starts with {"line": NUMBER,
    cat "$2"/task-*/results.jsonl | sort -t: -k2,2n >"$2/results.jsonl"
    exit
fi
mkdir -p "$2"
exec muslin dress --batch "$1" --part "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" \
    -o "$2/task-$SLURM_ARRAY_TASK_ID" --jobs "${SLURM_CPUS_PER_TASK:-1}" --quiet
