using UnityEngine;

namespace SphFluid
{
    /// <summary>Where a rigid body is: its centre of mass and its principal axes, in simulation space.</summary>
    internal readonly struct FloatingPose
    {
        public FloatingPose(Vector3 centre, Quaternion rotation)
        {
            Centre = centre;
            Rotation = rotation;
        }

        /// <summary>Centre of mass [m].</summary>
        public Vector3 Centre { get; }

        /// <summary>Principal axes to simulation space.</summary>
        public Quaternion Rotation { get; }

        /// <summary>A point of simulation space in the frame of the body.</summary>
        public Vector3 ToBody(Vector3 point) => Quaternion.Inverse(Rotation) * (point - Centre);

        /// <summary>A rotation to simulation space as one to the frame of the body.</summary>
        public Quaternion ToBody(Quaternion rotation) => Quaternion.Inverse(Rotation) * rotation;

        /// <summary>The turn from another pose to this one, as a vector along its axis [rad].</summary>
        public Vector3 TurnFrom(in FloatingPose other) => Turn(Rotation * Quaternion.Inverse(other.Rotation));

        /// <summary>A rotation as a vector along its axis [rad], the shorter way round.</summary>
        public static Vector3 Turn(Quaternion q)
        {
            var axis = new Vector3(q.x, q.y, q.z);
            if (q.w < 0f) axis = -axis;
            float sine = axis.magnitude;
            return sine < 1e-6f ? 2f * axis : axis * (2f * Mathf.Atan2(sine, Mathf.Abs(q.w)) / sine);
        }
    }
}
