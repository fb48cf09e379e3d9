using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>Reports once a run for each kind of guard that had to act on the particles.</summary>
    internal sealed class GuardMonitor
    {
        private bool nonFinite, clamped, limited, squeezed, overlapped, shortened, cut;

        /// <summary>What to do about what was last reported.</summary>
        public string Cure { get; private set; }

        /// <summary>Takes note of the counters.</summary>
        /// <param name="counters">What the GPU counted.</param>
        /// <param name="shorterSteps">What makes the steps shorter, the beginning of a cure.</param>
        /// <param name="squeezers">Numbers of the bodies that squeezed particles last.</param>
        /// <param name="bodies">The scene's bodies; null for none.</param>
        /// <returns>What to report to the user; null when nothing new.</returns>
        public string Update(in FluidCounters counters, string shorterSteps, uint squeezers = 0u, CollisionBodies bodies = null)
        {
            List<string> news = null;
            bool wasSqueezed = squeezed, wasOverlapped = overlapped;
            if (IsNew(counters.NonFinite, ref nonFinite))
            {
                Add(ref news, $"{counters.NonFinite} positions or velocities were not finite and were stopped");
            }
            if (IsNew(counters.DomainClamps, ref clamped))
            {
                Add(ref news, $"{counters.DomainClamps} particles were put back onto the domain's faces");
            }
            if (IsNew(counters.AccelerationLimitHits, ref limited))
            {
                Add(ref news, $"{counters.AccelerationLimitHits} accelerations were limited");
            }
            if (IsNew(counters.Squeezed, ref squeezed))
            {
                Add(ref news,
                    $"{counters.Squeezed} times a particle had no place between {Closing(squeezers, bodies)} and was left where it was");
            }
            if (IsNew(counters.Overlaps, ref overlapped))
            {
                Add(ref news, $"{counters.Overlaps} times a collider was already on a particle and the side was chosen for it");
            }
            if (IsNew(counters.ShortenedSteps, ref shortened))
            {
                Add(ref news, $"{counters.ShortenedSteps} steps were longer than colliders can stop and were shortened");
            }
            if (IsNew(counters.ImpulseLimits, ref cut))
            {
                Add(ref news, $"{counters.ImpulseLimits} impulses on bodies were larger than their sums hold and were cut");
            }
            if (news == null) return null;
            var cures = new List<string>();
            if (squeezed != wasSqueezed) cures.Add("Stop colliders that close a spacing apart, and leave the liquid a way out.");
            if (overlapped != wasOverlapped) cures.Add("Enable and place colliders where no liquid is.");
            if (news.Count > cures.Count)
            {
                cures.Add(shorterSteps +
                    ", or raise Expected Speed or set Time Step Mode to Adaptive when colliders or forces move the liquid faster than " +
                    "its fall.");
            }
            Cure = string.Join(" ", cures);
            return $"The solver's guards acted: {string.Join(", ", news)}.";
        }

        private static string Closing(uint squeezers, CollisionBodies bodies)
        {
            uint first = squeezers >> 16, second = squeezers & 0xffffu;
            return first == 0u || bodies == null ? "colliders that close" : $"{bodies.NameOf(first)} and {bodies.NameOf(second)}";
        }

        private static void Add(ref List<string> news, string text) => (news ??= new List<string>()).Add(text);

        private static bool IsNew(long count, ref bool reported)
        {
            if (reported || count == 0) return false;
            return reported = true;
        }
    }
}
