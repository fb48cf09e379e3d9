using System;

namespace SphFluid
{
    /// <summary>
    /// Watches for frames that asked for more substeps than allowed and says so once an episode: an episode ends after
    /// a second without such a frame.
    /// </summary>
    internal sealed class SubstepMonitor
    {
        const double QuietTime = 1.0;
        const double Smoothing = 0.1;
        const double RoundingSlack = 1e-6;

        bool lagging;
        double quiet;

        /// <summary>Frames since the start in which the cap was reached.</summary>
        public long CapHits { get; private set; }

        /// <summary>Simulated time over frame time, smoothed; 1 keeps up.</summary>
        public double RealTimeFactor { get; private set; } = 1.0;

        /// <summary>Takes note of a frame.</summary>
        /// <param name="clock">Clock after its Advance.</param>
        /// <param name="steps">Steps that it gave.</param>
        /// <param name="deltaTime">Frame time [s].</param>
        /// <returns>What to tell the user; null when nothing new.</returns>
        public string Note(IStepClock clock, int steps, double deltaTime)
        {
            if (!(deltaTime > 0.0)) return null;
            bool capped = clock.LastDroppedTime > 0.0;
            double factor = capped ? steps * clock.TimeStep / deltaTime : 1.0;
            RealTimeFactor += (factor - RealTimeFactor) * Smoothing;
            if (!capped)
            {
                quiet += deltaTime;
                if (quiet >= QuietTime) lagging = false;
                return null;
            }
            CapHits++;
            quiet = 0.0;
            if (lagging) return null;
            lagging = true;
            double needed = steps + Math.Ceiling(clock.LastDroppedTime / clock.TimeStep - RoundingSlack);
            return FormattableString.Invariant(
                $"A frame of {1e3 * deltaTime:0.#} ms needs {needed} steps of {1e3 * clock.TimeStep:0.###} ms, but at most {clock.MaxSteps} are allowed, so the liquid moves at {100.0 * factor:0} % of real time.");
        }
    }
}
