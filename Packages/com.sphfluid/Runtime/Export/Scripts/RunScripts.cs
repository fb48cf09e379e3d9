using System.Globalization;

namespace SphFluid
{
    /// <summary>run.sh for one machine and job.sbatch for a cluster with Slurm. The same for every case but for the number of processes.</summary>
    internal static class RunScripts
    {
        /// <summary>One of them.</summary>
        /// <param name="script">Which.</param>
        /// <param name="ranks">Processes that it starts unless it is told otherwise.</param>
        public static string With(string script, int ranks) => script.Replace("@RANKS@", ranks.ToString(CultureInfo.InvariantCulture));

        public const string Local = @"#!/usr/bin/env bash
# Runs the case and makes sequence/ of it. RANKS: processes; PYTHON: the interpreter that has PySPH; flags go to case.py.
set -euo pipefail
cd ""$(dirname ""${BASH_SOURCE[0]}"")""
ranks=${RANKS:-@RANKS@} python=${PYTHON:-python3}
rm -rf out # files of an earlier run would be taken for frames of this one
if ((ranks > 1)); then
    export OMP_NUM_THREADS=${OMP_NUM_THREADS:-1}
    flags=(-n ""$ranks"")
    # Open MPI starts nothing as root, and no more processes than there are cores, unless told to.
    ((EUID != 0)) || flags+=(--allow-run-as-root)
    ((ranks <= $(getconf _NPROCESSORS_ONLN))) || flags+=(--oversubscribe)
    mpirun ""${flags[@]}"" ""$python"" case.py -d out ""$@""
else
    ""$python"" case.py --openmp -d out ""$@""
fi
""$python"" to_sequence.py out sequence
[[ ! -e readings.py ]] || ""$python"" readings.py out readings.csv
";

        public const string Slurm = @"#!/usr/bin/env bash
#SBATCH --job-name=sphfluid
#SBATCH --ntasks=@RANKS@
#SBATCH --cpus-per-task=1
#SBATCH --time=24:00:00
#SBATCH --output=slurm-%j.txt
# sbatch job.sbatch, from this folder; sbatch --ntasks=256 job.sbatch for more processes.
set -euo pipefail
cd ""$SLURM_SUBMIT_DIR""
rm -rf out # files of an earlier run would be taken for frames of this one
export OMP_NUM_THREADS=$SLURM_CPUS_PER_TASK
# Not srun: it starts MPI only where both have a PMI in common.
mpirun -n ""$SLURM_NTASKS"" ""${PYTHON:-python3}"" case.py -d out
""${PYTHON:-python3}"" to_sequence.py out sequence
[[ ! -e readings.py ]] || ""${PYTHON:-python3}"" readings.py out readings.csv
";
    }
}
