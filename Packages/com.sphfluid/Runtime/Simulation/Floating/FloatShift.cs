using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A displacement or turn that a body is given as a velocity for one physics step, and that is taken back after it: so that contacts
    /// can refuse it, and that a body which is drawn between its steps goes there evenly.
    /// </summary>
    internal struct FloatShift
    {
        private Vector3 given;

        /// <summary>Velocity that the next step is to have besides the body's own [m/s].</summary>
        public Vector3 Next;

        /// <summary>Begins a step.</summary>
        /// <returns>What to add to the body's velocity.</returns>
        public Vector3 Begin()
        {
            (given, Next) = (Next, Vector3.zero);
            return given;
        }

        /// <summary>Ends a step.</summary>
        /// <param name="velocity">The body's velocity after it.</param>
        /// <param name="expected">The same without a shift and if nothing is in its way.</param>
        /// <param name="kept">Part of a velocity that damping leaves in the step.</param>
        /// <param name="left">What the body still has of the shift [m/s].</param>
        /// <returns>The part of the shift that was refused [m/s].</returns>
        public Vector3 End(Vector3 velocity, Vector3 expected, float kept, out Vector3 left)
        {
            Vector3 shift = kept * given;
            float squared = shift.sqrMagnitude;
            float part = squared > 0f ? Mathf.Clamp01(Vector3.Dot(velocity - expected, shift) / squared) : 0f;
            left = (part > 0.99f ? 1f : part) * shift; // rounding refuses nothing
            given = Vector3.zero;
            return shift - left;
        }
    }
}
