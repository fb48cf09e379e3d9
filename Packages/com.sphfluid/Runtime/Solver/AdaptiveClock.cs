using System;

namespace SphFluid
{
    /// <summary>
    /// Cuts each frame into the fewest equal steps that are short enough. They fill the frame: no rest is left for a short step, which
    /// would turn density errors into velocity. Steps shorten at once and lengthen slowly, so that their number does not flicker.
    /// Where a frame asks for more steps than allowed, they keep their stable length and the surplus is dropped and reported.
    /// </summary>
    internal sealed class AdaptiveClock : IStepClock
    {
        // A frame of exactly n steps must give n, however its float was rounded.
        private const double RoundingSlack = 1e-6;

        /// <summary>The longest stable step over the steps that a calm liquid takes: what its speed flickers by.</summary>
        internal const double Margin = 1.05;

        // The target grows by 2 % a frame.
        private const double Growth = 1.02;

        private double stable, target, pending;

        /// <summary>Creates a clock at time zero.</summary>
        /// <param name="stableStep">Longest step now [s], positive.</param>
        /// <param name="maxSteps">Most steps a frame, one or more.</param>
        /// <exception cref="ArgumentOutOfRangeException">An argument is out of range.</exception>
        public AdaptiveClock(double stableStep, int maxSteps)
        {
            if (maxSteps < 1)
            {
                throw new ArgumentOutOfRangeException(nameof(maxSteps), maxSteps, "A frame must be allowed one step or more.");
            }

            target = double.PositiveInfinity;
            StableStep = stableStep;
            MaxSteps = maxSteps;
            TimeStep = stableStep;
        }

        /// <summary>Longest step now [s], positive; set it before each frame.</summary>
        /// <exception cref="ArgumentOutOfRangeException">It is not positive, or not finite.</exception>
        public double StableStep
        {
            get => stable;
            set
            {
                if (!(value > 0.0) || double.IsInfinity(value))
                {
                    throw new ArgumentOutOfRangeException(nameof(value), value, "The time step must be a positive number of seconds.");
                }

                stable = value;
                target = Math.Min(value, target);
            }
        }

        /// <summary>What the next frame goes by; for saves.</summary>
        internal (double target, double pending, double step) Progress
        {
            get => (target, pending, TimeStep);
            set => (target, pending, TimeStep) = value;
        }

        /// <inheritdoc/>
        public int MaxSteps { get; }

        /// <inheritdoc/>
        public double TimeStep { get; private set; }

        /// <inheritdoc/>
        public double LastDroppedTime { get; private set; }

        /// <inheritdoc/>
        public int Advance(double deltaTime)
        {
            if (!(deltaTime >= 0.0) || double.IsInfinity(deltaTime))
            {
                throw new ArgumentOutOfRangeException(nameof(deltaTime), deltaTime, "Frame time must be zero or more.");
            }

            LastDroppedTime = 0.0;
            if (deltaTime == 0.0) return 0;

            target = Math.Max(target, Math.Min(target * Growth, stable / Margin));
            pending += deltaTime;
            if (pending < 0.5 * target) return 0; // frames shorter than half a step wait for each other

            double time = pending;
            pending = 0.0;
            double needed = Math.Max(1.0, Math.Ceiling(time / target - RoundingSlack));
            int steps = (int)Math.Min(needed, MaxSteps);
            TimeStep = needed > steps ? target : time / steps;
            LastDroppedTime = needed > steps ? time - steps * target : 0.0;
            return steps;
        }

        /// <inheritdoc/>
        public void StepOnce()
        {
            LastDroppedTime = 0.0;
            TimeStep = Math.Min(target, stable / Margin);
        }
    }
}
