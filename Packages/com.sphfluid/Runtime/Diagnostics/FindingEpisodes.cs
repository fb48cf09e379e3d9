using System;

namespace SphFluid
{
    /// <summary>Reports a failure once an episode: the episode ends after a while of measurements without it.</summary>
    internal sealed class FindingEpisodes
    {
        private const int QuietMeasurements = 10;

        private static readonly int Failures = Enum.GetValues(typeof(FluidFailure)).Length;

        private readonly long[] lastSeen = new long[Failures];
        private long now = QuietMeasurements;

        /// <summary>Begins the next measurement.</summary>
        public void Begin() => now++;

        /// <summary>Takes note of a failure in this measurement.</summary>
        /// <returns>Whether its episode begins.</returns>
        public bool IsNew(FluidFailure failure)
        {
            bool begins = now - lastSeen[(int)failure] > QuietMeasurements;
            lastSeen[(int)failure] = now;
            return begins;
        }

        /// <summary>Forgets all episodes.</summary>
        public void Clear()
        {
            Array.Clear(lastSeen, 0, lastSeen.Length);
            now = QuietMeasurements;
        }
    }
}
