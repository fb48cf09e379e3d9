using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>A state that another program computed.</summary>
    internal readonly struct PeerSample
    {
        /// <summary>A state.</summary>
        /// <param name="time">Time since the start [s].</param>
        /// <param name="state">The particles.</param>
        /// <param name="pressures">Mean pressures on the set-up's patches since the sample before [Pa]; null for none.</param>
        public PeerSample(double time, FluidSnapshot state, IReadOnlyList<double> pressures = null)
        {
            Time = time;
            State = state;
            Pressures = pressures ?? Array.Empty<double>();
        }

        /// <summary>Time since the start [s].</summary>
        public double Time { get; }

        /// <summary>The particles.</summary>
        public FluidSnapshot State { get; }

        /// <summary>Mean pressures on the set-up's patches since the sample before [Pa].</summary>
        public IReadOnlyList<double> Pressures { get; }

        /// <summary>Shows states to a metric as a run of ours does, and ends where that finds it failed.</summary>
        /// <param name="setup">What was run.</param>
        /// <param name="metric">What watches it.</param>
        /// <param name="samples">The states in the order of their times.</param>
        public static CaseResult Evaluate(CaseSetup setup, CaseMetric metric, IEnumerable<PeerSample> samples)
        {
            var failures = new CaseFailure(setup);
            var result = new CaseResult { Particles = setup.Particles.Length };
            foreach (PeerSample sample in samples)
            {
                result.SimulatedSeconds = sample.Time;
                result.Failure = failures.Of(sample.State);
                if (result.Failure == null)
                {
                    metric.Read(sample.Time, new CaseReadings(Array.Empty<UnityEngine.Vector3>(), sample.Pressures));
                    metric.Sample(sample.Time, sample.State);
                    result.Failure = metric.Failure;
                }
                if (result.Failure != null)
                {
                    result.Failure = FormattableString.Invariant($"{result.Failure}, at {sample.Time:G3} s");
                    break;
                }
            }
            result.Take(metric);
            return result;
        }
    }
}
