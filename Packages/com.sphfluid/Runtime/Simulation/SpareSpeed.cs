using System;

namespace SphFluid
{
    /// <summary>
    /// How fast a liquid may be taken for at no cost. A frame is cut into equal steps, so a softer liquid, which bears longer ones, costs
    /// less only where a whole step is saved. Worked example: a frame of 3.3 of the longest steps takes 4, and 4 do for a speed of sound
    /// that is higher by 15 %, with the clock's margin; liquid is then compressed by a quarter less.
    /// </summary>
    internal static class SpareSpeed
    {
        // Of an interval: the speed is found within 2e-5 of it.
        private const int Halvings = 16;

        // Of a step: shorter frames wait for each other (AdaptiveClock).
        private const double OneOfSeveralFrames = 0.5;

        /// <summary>The highest speed for which a frame takes no more steps than for a lower one [m/s].</summary>
        /// <param name="frame">Length of the frame [s].</param>
        /// <param name="speed">The lower speed [m/s].</param>
        /// <param name="most">The highest that is asked for [m/s].</param>
        /// <param name="maxSteps">Steps that a frame may have.</param>
        /// <param name="longestStep">The longest step [s] of a liquid whose constants are made for a speed; longer for lower ones.</param>
        /// <returns>The lower speed, where the frame needs its steps for that.</returns>
        public static double For(double frame, double speed, double most, int maxSteps, Func<double, double> longestStep)
        {
            if (!(speed < most)) return speed;
            double quotient = frame / longestStep(speed), steps = Math.Ceiling(quotient);
            if (quotient < OneOfSeveralFrames || steps > maxSteps) return speed;
            double low = speed, high = most;
            for (int halving = 0; halving < Halvings; halving++)
            {
                double middle = 0.5 * (low + high);
                if (steps * longestStep(middle) >= AdaptiveClock.Margin * frame) low = middle;
                else high = middle;
            }

            return low;
        }
    }
}
