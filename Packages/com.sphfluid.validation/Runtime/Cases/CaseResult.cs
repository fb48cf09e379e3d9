using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>What one run of a case gave.</summary>
    public sealed class CaseResult
    {
        /// <summary>Errors, the main one first; empty for a run that failed before its end.</summary>
        public IReadOnlyList<CaseError> Errors = System.Array.Empty<CaseError>();

        /// <summary>Curves for a picture.</summary>
        public IReadOnlyList<CaseSeries> Series = System.Array.Empty<CaseSeries>();

        /// <summary>Why it failed; null when it did not.</summary>
        public string Failure;

        /// <summary>Number of particles.</summary>
        public int Particles;

        /// <summary>Steps done.</summary>
        public long Steps;

        /// <summary>What the solver counted.</summary>
        public FluidCounters Counters;

        /// <summary>Simulated time [s]; less than the case's length when it failed.</summary>
        public double SimulatedSeconds;

        /// <summary>Length of a step [s].</summary>
        public double TimeStep = double.NaN;

        /// <summary>GPU times of a step over the parts of the run [ms].</summary>
        public StepTimes GpuTimes = StepTimes.None;

        /// <summary>GPU time of the steps per simulated second [ms/s]; not a number when it was not measured.</summary>
        public double GpuMsPerSecond = double.NaN;

        /// <summary>CPU time of recording and submitting the steps per simulated second [ms/s].</summary>
        public double CpuMsPerSecond = double.NaN;

        /// <summary>Whether it failed.</summary>
        public bool Failed => Failure != null;

        /// <summary>
        /// Takes a metric's curves and, of a run that has not failed, its errors. A fit that ended at the bound of its search is a failure.
        /// </summary>
        internal void Take(CaseMetric metric)
        {
            Series = metric.Series();
            if (Failed) return;
            try
            {
                Errors = metric.Evaluate();
            }
            catch (SearchBoundException exception)
            {
                Failure = exception.Message;
            }
        }
    }
}
