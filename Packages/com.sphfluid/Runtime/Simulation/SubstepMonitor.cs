using System;

namespace SphFluid
{
    /// <summary>
    /// Watches for a liquid that cannot keep up with time because frames need more substeps than allowed, and reports it once an episode. A
    /// single long frame is not reported: a scene that loads, a shader that compiles and a window that is dragged make one each. An episode
    /// begins after <see cref="LastingTime"/> of capped frames, and ends after a second without one.
    /// </summary>
    internal sealed class SubstepMonitor
    {
        /// <summary>Capped frames of so much time, with no quiet second between them, are an overload [s].</summary>
        public const double LastingTime = 0.5;

        /// <summary>Frames after the start that no episode begins in: they compile, allocate and load.</summary>
        public const int StartFrames = 3;

        // A frame counts for no more than this, so that it takes several to make an episode.
        private const double LongestShare = 0.1;

        private const double QuietTime = 1.0;
        private const double Smoothing = 0.1;
        private const double RoundingSlack = 1e-6;

        private bool lagging;
        private double capped, quiet;
        private long frames;

        /// <summary>Frames since the start in which the cap was reached.</summary>
        public long CapHits { get; private set; }

        /// <summary>Simulated time over frame time, smoothed; 1 keeps up.</summary>
        public double RealTimeFactor { get; private set; } = 1.0;

        /// <summary>Takes note of a frame in which the liquid rests and needs no steps.</summary>
        /// <param name="deltaTime">Frame time [s].</param>
        public void Rest(double deltaTime)
        {
            if (!(deltaTime > 0.0)) return;
            RealTimeFactor += (1.0 - RealTimeFactor) * Smoothing;
            NoteQuiet(deltaTime);
        }

        /// <summary>Takes note of a frame.</summary>
        /// <param name="clock">Clock after its Advance.</param>
        /// <param name="steps">Steps that it gave.</param>
        /// <param name="deltaTime">Frame time [s].</param>
        /// <returns>What to report; null when nothing new.</returns>
        public string Update(IStepClock clock, int steps, double deltaTime)
        {
            if (!(deltaTime > 0.0)) return null;
            frames++;
            bool hit = clock.LastDroppedTime > 0.0;
            double factor = hit ? steps * clock.TimeStep / deltaTime : 1.0;
            RealTimeFactor += (factor - RealTimeFactor) * Smoothing;
            if (!hit)
            {
                NoteQuiet(deltaTime);
                return null;
            }
            CapHits++;
            quiet = 0.0;
            if (frames <= StartFrames) return null;
            capped += Math.Min(deltaTime, LongestShare);
            if (lagging || capped < LastingTime - RoundingSlack) return null;
            lagging = true;
            double needed = steps + Math.Ceiling(clock.LastDroppedTime / clock.TimeStep - RoundingSlack);
            return FormattableString.Invariant(
                $"A frame of {1e3 * deltaTime:0.#} ms needs {needed} steps of {1e3 * clock.TimeStep:0.###} ms, ") +
                FormattableString.Invariant($"but at most {clock.MaxSteps} are allowed, so the liquid moves at {100.0 * factor:0} % of ") +
                "real time " +
                FormattableString.Invariant($"({CapHits} such frames so far).");
        }

        private void NoteQuiet(double deltaTime)
        {
            quiet += deltaTime;
            if (quiet < QuietTime) return;
            lagging = false;
            capped = 0.0;
        }
    }
}
