#!/bin/sh
# A job array with a task for each part. From the folder with part.sh:
#     sbatch --array=1-16 slurm.sh traj.xyz 16
# What a node that failed left undone is submitted again in the same way, the parts named alone: sbatch --array=3,7 slurm.sh traj.xyz 16
#SBATCH --job-name=frames
#SBATCH --output=part-%a.log
#SBATCH --open-mode=append
set -eu
# Slurm runs a copy of this file from somewhere else.
cd "$SLURM_SUBMIT_DIR"
exec sh ./part.sh "$1" "$SLURM_ARRAY_TASK_ID" "$2"
