using System;

namespace SphFluid.Validation
{
    /// <summary>
    /// When a run is looked at. Steps have one length, leapfrog needs that, so a sample comes at the end of the step that ends nearest
    /// to its time: with dt = 0.03 s and an interval of 0.1 s at 0, 0.09, 0.21, 0.3 s, …
    /// </summary>
    public sealed class CaseSchedule
    {
        private readonly double interval;

        /// <summary>Samples of a run.</summary>
        /// <param name="duration">Length of the run [s].</param>
        /// <param name="interval">Time between two samples [s].</param>
        /// <param name="timeStep">Length of a step [s].</param>
        /// <exception cref="ArgumentException">One is not a positive number.</exception>
        public CaseSchedule(double duration, double interval, double timeStep)
        {
            Require(duration, "duration");
            Require(interval, "time between samples");
            Require(timeStep, "time step");
            this.interval = interval;
            TimeStep = timeStep;
            LastStep = Math.Max(1L, (long)Math.Round(duration / timeStep));
        }

        /// <summary>Length of a step [s].</summary>
        public double TimeStep { get; }

        /// <summary>Steps of the whole run: its true length is within half a step of the one asked for.</summary>
        public long LastStep { get; }

        /// <summary>The step after which the next sample is due, at least one on; the last is the end of the run.</summary>
        /// <param name="step">Steps done.</param>
        public long Next(long step)
        {
            // A sample's number is that of the nearest one: two that fall onto one step are one.
            long number = (long)Math.Floor((step + 0.5) * TimeStep / interval) + 1;
            long next = Math.Max(step + 1, (long)Math.Round(number * interval / TimeStep));
            return Math.Min(next, LastStep);
        }

        private static void Require(double value, string name)
        {
            if (!(value > 0.0) || double.IsInfinity(value))
            {
                throw new ArgumentException(
                    FormattableString.Invariant($"The run's {name} is {value} s; it must be a positive number of seconds."));
            }
        }
    }
}
