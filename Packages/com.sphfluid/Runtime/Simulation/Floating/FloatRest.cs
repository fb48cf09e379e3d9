using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// When a body in calm liquid sleeps: PhysX need not be told of gravity and the liquid's push while they are as they were when it came
    /// to rest.
    /// </summary>
    internal struct FloatRest
    {
        private const float Patience = 1f, Smoothing = 0.4f; // s

        // Of the energy below which PhysX lets a body sleep: a tenth of the speed, and half of it.
        private const float Calm = 0.01f, Stirred = 0.25f;

        private Vector3 mean, gained; // acceleration while awake [m/s²]; velocity by what has changed of it since [m/s]
        private float calm;

        /// <summary>It falls asleep: one that is woken at once is calm anew.</summary>
        public void Begin() => calm = 0f;

        /// <summary>A frame of a body.</summary>
        /// <param name="asleep">Whether it sleeps.</param>
        /// <param name="acceleration">By the liquid and gravity [m/s²].</param>
        /// <param name="energy">Its energy over its mass [m²/s²].</param>
        /// <param name="threshold">Below this PhysX lets it sleep.</param>
        /// <param name="time">Of the frame [s].</param>
        /// <returns>Whether it is to fall asleep, or to wake.</returns>
        public bool Turns(bool asleep, Vector3 acceleration, float energy, float threshold, float time)
        {
            float part = Mathf.Min(1f, time / Smoothing);
            gained = asleep ? (1f - part) * gained + time * (acceleration - mean) : Vector3.zero;
            if (asleep) return 0.5f * gained.sqrMagnitude > Stirred * threshold;
            mean += part * (acceleration - mean);
            calm = energy < Calm * threshold ? calm + time : 0f;
            return calm > Patience;
        }
    }
}
