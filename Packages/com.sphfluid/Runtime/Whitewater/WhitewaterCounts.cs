using UnityEngine;

namespace SphFluid
{
    /// <summary>How much whitewater there is and was, as of the last finished read-back (a few frames old).</summary>
    public readonly struct WhitewaterCounts
    {
        internal WhitewaterCounts(uint particles, uint born, uint refused, Vector3 limits)
        {
            Particles = particles;
            Born = born;
            Refused = refused;
            Limits = limits;
        }

        /// <summary>Particles of spray, foam and bubbles.</summary>
        public long Particles { get; }

        /// <summary>Particles that were born since the start.</summary>
        public long Born { get; }

        /// <summary>
        /// Particles that the liquid asked for since the start and that were not born, because there were as many as there may be.
        /// </summary>
        public long Refused { get; }

        /// <summary>
        /// Running means of the largest trapped air [m/s], wave crest and kinetic energy [J/kg] of a frame, by which whitewater is born.
        /// </summary>
        public Vector3 Limits { get; }
    }
}
