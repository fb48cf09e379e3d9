using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A collider that moves: its triangles rest in the simulation space of the moment when it was first seen, and its pose is the
    /// rigid motion since.
    /// </summary>
    internal sealed class BodyMotion
    {
        readonly Matrix4x4 referenceInverse;

        public BodyMotion(ColliderSolid solid)
        {
            Solid = solid;
            Friction = solid.State.Friction;
            referenceInverse = solid.State.ToSimulation.inverse;
            Rotation0 = Rotation1 = Quaternion.identity;
        }

        /// <summary>The collider with the triangles of the reference.</summary>
        public ColliderSolid Solid { get; }

        /// <summary>0 free slip to 1 no slip; negative: as the domain's faces.</summary>
        public float Friction { get; private set; }

        public Quaternion Rotation0 { get; private set; }
        public Vector3 Position0 { get; private set; }
        public Quaternion Rotation1 { get; private set; }
        public Vector3 Position1 { get; private set; }

        /// <summary>Whether the frame's motion is none.</summary>
        public bool IsAtRest => Position0 == Position1 && Rotation0.Equals(Rotation1);

        /// <summary>Ends the motion: it begins where it ended.</summary>
        public void Arrive()
        {
            Rotation0 = Rotation1;
            Position0 = Position1;
        }

        /// <summary>Sets the end of the motion, and the friction.</summary>
        /// <returns>False when the change is not rigid, so that the triangles have to be made anew.</returns>
        public bool MoveTo(in ColliderState state)
        {
            if (!state.HasShapeOf(Solid.State)) return false;
            Matrix4x4 motion = state.ToSimulation * referenceInverse;
            Vector3 x = motion.GetColumn(0), y = motion.GetColumn(1), z = motion.GetColumn(2);
            if (!IsRotation(x, y, z)) return false;
            Friction = state.Friction;
            Rotation1 = Quaternion.LookRotation(z, y);
            Position1 = motion.GetColumn(3);
            return true;
        }

        /// <summary>Largest way of a corner of the box in this frame [m].</summary>
        public float LongestWay(Vector3 min, Vector3 max)
        {
            float longest = 0f;
            for (int corner = 0; corner < 8; corner++)
            {
                var p = new Vector3((corner & 1) == 0 ? min.x : max.x, (corner & 2) == 0 ? min.y : max.y, (corner & 4) == 0 ? min.z : max.z);
                longest = Mathf.Max(longest, (Rotation1 * p + Position1 - Rotation0 * p - Position0).magnitude);
            }
            return longest;
        }

        static bool IsRotation(Vector3 x, Vector3 y, Vector3 z)
        {
            const float tolerance = 1e-3f;
            return Mathf.Abs(x.magnitude - 1f) < tolerance && Mathf.Abs(y.magnitude - 1f) < tolerance && Mathf.Abs(z.magnitude - 1f) < tolerance &&
                (Vector3.Cross(x, y) - z).magnitude < tolerance;
        }
    }
}
