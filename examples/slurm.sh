#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A long solve on a cluster: sbatch examples/slurm.sh SCENE.json OUT
#
# Ranks share the replicates of a solve, and threads of a rank its receivers: with compensated and gathered up to eight ranks have work.
# The checkpoint lets the same command go on where the time limit ended it; the numbers are those of one process.
#SBATCH --job-name=kalos
#SBATCH --ntasks=8
#SBATCH --cpus-per-task=16
#SBATCH --time=04:00:00
#SBATCH --requeue
set -eu
scene=${1:?usage: sbatch slurm.sh SCENE.json OUT}
out=${2:?usage: sbatch slurm.sh SCENE.json OUT}
${SRUN:-srun} kalos solve "$scene" --out "$out" --error 0.01 --threads "${SLURM_CPUS_PER_TASK:-0}" --checkpoint "$out.checkpoint"
