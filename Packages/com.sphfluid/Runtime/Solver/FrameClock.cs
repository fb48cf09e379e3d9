using System;

namespace SphFluid
{
    /// <summary>
    /// Cuts each frame into the same number of equal steps, however long it is: liquid by a fixed number of iterations keeps real time. A
    /// frame so long that its steps would be longer than allowed has more of them; what is beyond the most is dropped and reported. It
    /// remembers the longest step of late: liquid that is as stiff as that one allows does not notice that frames vary.
    /// </summary>
    internal sealed class FrameClock : IStepClock
    {
        // What was long is forgotten by 1 % a frame, so slowly that liquid at rest follows.
        private const double Forgetting = 0.99;

        private readonly int substeps;
        private readonly double longest;

        /// <summary>Creates a clock.</summary>
        /// <param name="substeps">Steps of a frame, one or more.</param>
        /// <param name="longestStep">Longest step [s], positive.</param>
        /// <param name="maxSteps">Most steps a frame; no fewer than <paramref name="substeps"/> count.</param>
        /// <param name="firstStep">Step before the first frame [s], positive.</param>
        /// <exception cref="ArgumentOutOfRangeException">An argument is out of range.</exception>
        public FrameClock(int substeps, double longestStep, int maxSteps, double firstStep)
        {
            if (substeps < 1) throw new ArgumentOutOfRangeException(nameof(substeps), substeps, "A frame must have one step or more.");
            RequirePositive(longestStep, nameof(longestStep));
            RequirePositive(firstStep, nameof(firstStep));
            this.substeps = substeps;
            longest = longestStep;
            MaxSteps = Math.Max(substeps, maxSteps);
            TimeStep = LongestOfLate = firstStep;
        }

        /// <summary>The longest step of late, no less than <see cref="TimeStep"/> [s].</summary>
        public double LongestOfLate { get; internal set; }

        /// <inheritdoc/>
        public int MaxSteps { get; }

        /// <inheritdoc/>
        public double TimeStep { get; internal set; }

        /// <inheritdoc/>
        public double LastDroppedTime { get; private set; }

        /// <summary>Makes the liquid as soft as steps of a length do, before they are taken.</summary>
        /// <param name="step">Their length [s].</param>
        public void Soften(double step) => LongestOfLate = Math.Max(LongestOfLate, Math.Min(step, longest));

        /// <summary>Steps of a frame.</summary>
        /// <param name="frameTime">Its time [s].</param>
        /// <param name="substeps">Steps that it is cut into where these are not too long.</param>
        /// <param name="longestStep">Longest step [s].</param>
        public static int StepsOf(double frameTime, int substeps, double longestStep) =>
            Math.Max(substeps, FrameWork.StepsOf(frameTime, longestStep));

        /// <inheritdoc/>
        public int Advance(double deltaTime)
        {
            if (!(deltaTime >= 0.0) || double.IsInfinity(deltaTime))
            {
                throw new ArgumentOutOfRangeException(nameof(deltaTime), deltaTime, "Frame time must be zero or more.");
            }
            LastDroppedTime = 0.0;
            if (deltaTime == 0.0) return 0;
            int needed = StepsOf(deltaTime, substeps, longest), steps = Math.Min(needed, MaxSteps);
            TimeStep = needed > steps ? longest : deltaTime / steps;
            LastDroppedTime = needed > steps ? deltaTime - steps * longest : 0.0;
            LongestOfLate = Math.Max(TimeStep, Forgetting * LongestOfLate);
            return steps;
        }

        /// <summary>Whether another clock cuts frames in the same way.</summary>
        public bool IsLike(FrameClock other) => other != null && other.substeps == substeps && other.longest == longest &&
            other.MaxSteps == MaxSteps;

        /// <inheritdoc/>
        public void StepOnce() => LastDroppedTime = 0.0;

        private static void RequirePositive(double value, string name)
        {
            if (!(value > 0.0) || double.IsInfinity(value))
            {
                throw new ArgumentOutOfRangeException(name, value, "The time step must be a positive number of seconds.");
            }
        }
    }
}
