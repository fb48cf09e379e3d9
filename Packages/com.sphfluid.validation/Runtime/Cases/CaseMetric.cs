using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>
    /// Watches one run of a case and measures its error. It sees snapshots and readings only, so that it can be tested on exact solutions.
    /// </summary>
    public abstract class CaseMetric
    {
        /// <summary>Why the run can be stopped before its end; null while it goes on well.</summary>
        public string Failure { get; protected set; }

        /// <summary>Looks at the state; called at time zero, then once each <see cref="CaseSetup.SampleInterval"/>.</summary>
        /// <param name="time">Time since the start [s].</param>
        /// <param name="state">The particles.</param>
        public abstract void Sample(double time, FluidSnapshot state);

        /// <summary>What the run knows besides its particles; called before <see cref="Sample"/>, with the same time.</summary>
        /// <param name="time">Time since the start [s].</param>
        /// <param name="readings">Where bodies are, and what walls bear.</param>
        public virtual void Read(double time, CaseReadings readings)
        {
        }

        /// <summary>The errors at the end, the case's main one first.</summary>
        /// <exception cref="SearchBoundException">A fit ended at the bound of its search.</exception>
        public abstract IReadOnlyList<CaseError> Evaluate();

        /// <summary>Measured and reference curves for a picture; empty when the case has none.</summary>
        public virtual IReadOnlyList<CaseSeries> Series() => System.Array.Empty<CaseSeries>();
    }
}
