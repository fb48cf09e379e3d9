using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>What became of a <see cref="FailureRun"/>.</summary>
    public sealed class FailureResult
    {
        private readonly Dictionary<FluidFailure, FluidFinding> findings = new Dictionary<FluidFailure, FluidFinding>();
        private readonly List<FluidStatistics> statistics = new List<FluidStatistics>();
        private readonly List<FluidSnapshot> states = new List<FluidSnapshot>();

        internal FailureResult(FailureRun run) => Run = run;

        /// <summary>What was run.</summary>
        public FailureRun Run { get; }

        /// <summary>The physics.</summary>
        public FluidSolverSettings Settings => Run.Settings;

        /// <summary>What the detectors said, before the start or at any sample: the first finding of each failure.</summary>
        public IReadOnlyCollection<FluidFinding> Findings => findings.Values;

        /// <summary>Statistics at the start and at each sample.</summary>
        public IReadOnlyList<FluidStatistics> Statistics => statistics;

        /// <summary>The particles at the start and at each sample, ordered by id.</summary>
        public IReadOnlyList<FluidSnapshot> States => states;

        /// <summary>The particles at the end.</summary>
        public FluidSnapshot End => states[states.Count - 1];

        /// <summary>Statistics at the end.</summary>
        public FluidStatistics EndStatistics => statistics[statistics.Count - 1];

        /// <summary>The guards' counts at the end.</summary>
        public FluidCounters Counters { get; internal set; }

        /// <summary>The neighbours at the end against brute force; null where no audit was asked for.</summary>
        public NeighbourAudit Audit { get; internal set; }

        /// <summary>The experiment's figure.</summary>
        public double Figure { get; internal set; }

        /// <summary>Whether a detector named the failure.</summary>
        /// <param name="failure">The failure.</param>
        public bool Names(FluidFailure failure) => findings.ContainsKey(failure);

        /// <summary>The failures that detectors named, by name, for messages.</summary>
        public string Named => findings.Count == 0 ? "none" : string.Join(", ", findings.Values.Select(f => f.Failure.ToString()));

        internal void Note(IEnumerable<FluidFinding> found)
        {
            foreach (FluidFinding finding in found)
            {
                if (!findings.ContainsKey(finding.Failure)) findings.Add(finding.Failure, finding);
            }
        }

        internal void Add(in FluidStatistics now, FluidSnapshot state)
        {
            statistics.Add(now);
            states.Add(state);
        }
    }
}
