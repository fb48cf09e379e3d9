using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A displacement that a body is given as a velocity for one physics step, and that is taken back after it: so that contacts can refuse it.
    /// </summary>
    internal struct FloatShift
    {
        Vector3 expected, given;

        /// <summary>Velocity that the next step is to have besides the body's own [m/s].</summary>
        public Vector3 Next;

        /// <summary>What the body still has of the last one [m/s].</summary>
        public Vector3 Left { get; private set; }

        /// <summary>Begins a step.</summary>
        /// <param name="velocity">The body's velocity after it, without a shift and if nothing is in its way.</param>
        /// <param name="kept">Part of a velocity that damping leaves in the step.</param>
        /// <returns>What to add to the body's velocity.</returns>
        public Vector3 Begin(Vector3 velocity, float kept)
        {
            Vector3 change = Next - Left;
            (expected, given, Next, Left) = (velocity, kept * Next, Vector3.zero, Vector3.zero);
            return change;
        }

        /// <summary>Ends a step.</summary>
        /// <param name="velocity">The body's velocity after it.</param>
        /// <returns>The part of the shift that was refused [m/s].</returns>
        public Vector3 End(Vector3 velocity)
        {
            float squared = given.sqrMagnitude;
            float kept = squared > 0f ? Mathf.Clamp01(Vector3.Dot(velocity - expected, given) / squared) : 0f;
            Left = kept * given;
            Vector3 refused = given - Left;
            given = Vector3.zero;
            return refused;
        }
    }
}
