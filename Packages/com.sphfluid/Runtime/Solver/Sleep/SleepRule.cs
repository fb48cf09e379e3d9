using UnityEngine;

namespace SphFluid
{
    /// <summary>When a part of a liquid is calm, and for how long it must be before it sleeps.</summary>
    internal readonly struct SleepRule
    {
        /// <param name="fastest">Speed that no particle of a calm brick has [m/s].</param>
        /// <param name="drift">Speed that a calm brick as a whole does not have [m/s].</param>
        /// <param name="calmTime">How long a brick and those around it must be calm [s].</param>
        public SleepRule(float fastest, float drift, float calmTime, float tau, float still) => (Fastest, Drift, CalmTime, Tau, Still) = (fastest, drift, calmTime, tau, still);

        public float Fastest { get; }
        public float Drift { get; }
        public float CalmTime { get; }
        public float Tau { get; }
        public float Still { get; }
    }
}
