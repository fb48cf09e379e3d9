using System;

namespace SphFluid
{
    /// <summary>
    /// What a frame of a liquid needs, in numbers that are the same on every device; what a pass and a sort cost there is measured.
    /// </summary>
    internal readonly struct FrameWork
    {
        /// <summary>The work of a frame.</summary>
        /// <param name="steps">Its steps.</param>
        /// <param name="passesPerStep">Passes over all pairs of neighbours in each.</param>
        /// <param name="sorts">Sorts and searches for neighbours in the frame.</param>
        /// <param name="morePasses">Passes besides, for readers.</param>
        public FrameWork(int steps, double passesPerStep, double sorts, double morePasses = 0.0)
        {
            Steps = steps;
            PassesPerStep = passesPerStep;
            Sorts = sorts;
            MorePasses = morePasses;
        }

        /// <summary>Steps.</summary>
        public int Steps { get; }

        /// <summary>Passes over all pairs of neighbours in a step.</summary>
        public double PassesPerStep { get; }

        /// <summary>Sorts and searches for neighbours.</summary>
        public double Sorts { get; }

        /// <summary>Passes besides those of the steps.</summary>
        public double MorePasses { get; }

        /// <summary>Passes of the frame.</summary>
        public double Passes => Steps * PassesPerStep + MorePasses;

        /// <summary>Steps of at most a length that fill a frame.</summary>
        public static int StepsOf(double frameTime, double step) =>
            (int)Math.Min(int.MaxValue, Math.Max(1.0, Math.Ceiling(frameTime / step - 1e-6)));
    }
}
