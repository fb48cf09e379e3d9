using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>Tells once a run for each kind of guard that had to act on the particles.</summary>
    internal sealed class GuardMonitor
    {
        bool nonFinite, clamped, limited;

        /// <summary>Takes note of the counters.</summary>
        /// <returns>What to tell the user; null when nothing new.</returns>
        public string Note(in FluidCounters counters)
        {
            List<string> news = null;
            if (IsNew(counters.NonFinite, ref nonFinite)) Add(ref news, $"{counters.NonFinite} positions or velocities were not finite and were stopped");
            if (IsNew(counters.DomainClamps, ref clamped)) Add(ref news, $"{counters.DomainClamps} particles were put back onto the domain's faces");
            if (IsNew(counters.AccelerationLimitHits, ref limited)) Add(ref news, $"{counters.AccelerationLimitHits} accelerations were limited");
            return news == null ? null : $"The solver's guards acted: {string.Join(", ", news)}.";
        }

        static void Add(ref List<string> news, string text) => (news ??= new List<string>()).Add(text);

        static bool IsNew(long count, ref bool told)
        {
            if (told || count == 0) return false;
            return told = true;
        }
    }
}
