using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The rigid motion of a collider, frame by frame, about the pivot of its object.</summary>
    internal sealed class BodyPath
    {
        // Of unit vectors' products: how far from rigid a motion may be.
        private const float RigidTolerance = 1e-3f;

        // Of a quaternion's numbers: less than rounding makes is no turn.
        private const float TurnTolerance = 1e-5f;

        private readonly List<BodyPose> poses = new List<BodyPose>();
        private readonly Matrix4x4 fromStart; // simulation space at the start to the collider's own

        /// <param name="start">The collider's space to simulation space, at the first pose; not singular.</param>
        public BodyPath(in Matrix4x4 start)
        {
            AffineMath.TryInvert(start, out fromStart);
            Pivot = start.GetColumn(3);
            poses.Add(new BodyPose { Position = Pivot, Rotation = Quaternion.identity });
        }

        /// <summary>The pivot at the first pose [m].</summary>
        public Vector3 Pivot { get; }

        /// <summary>The poses, the first at time 0.</summary>
        public IReadOnlyList<BodyPose> Poses => poses;

        /// <summary>Adds where the collider is now.</summary>
        /// <param name="time">Time since the first pose [s].</param>
        /// <param name="now">The collider's space to simulation space.</param>
        /// <returns>False where the motion since the start is not rigid: the collider was scaled.</returns>
        public bool TryAdd(double time, in Matrix4x4 now)
        {
            Matrix4x4 turn = now * fromStart;
            if (!IsRigid(turn)) return false;
            Quaternion rotation = turn.rotation;
            Quaternion before = poses[poses.Count - 1].Rotation;
            if (Quaternion.Dot(before, rotation) < 0f) rotation = new Quaternion(-rotation.x, -rotation.y, -rotation.z, -rotation.w);
            poses.Add(new BodyPose { Time = time, Position = now.GetColumn(3), Rotation = rotation });
            return true;
        }

        /// <summary>Adds a pose that is the last one again.</summary>
        /// <param name="time">Time since the first pose [s].</param>
        public void Stay(double time)
        {
            BodyPose last = poses[poses.Count - 1];
            last.Time = time;
            poses.Add(last);
        }

        /// <summary>Whether it ever is elsewhere than at its first pose.</summary>
        /// <param name="tolerance">Distance that is no motion [m].</param>
        public bool Moves(float tolerance)
        {
            foreach (BodyPose pose in poses)
                if ((pose.Position - Pivot).magnitude > tolerance || 1f - Mathf.Abs(pose.Rotation.w) > TurnTolerance) return true;
            return false;
        }

        private static bool IsRigid(in Matrix4x4 m)
        {
            Vector3 x = m.GetColumn(0), y = m.GetColumn(1), z = m.GetColumn(2);
            return Mathf.Abs(x.sqrMagnitude - 1f) < RigidTolerance && Mathf.Abs(y.sqrMagnitude - 1f) < RigidTolerance &&
                Mathf.Abs(z.sqrMagnitude - 1f) < RigidTolerance &&
                Mathf.Abs(Vector3.Dot(x, y)) < RigidTolerance && Mathf.Abs(Vector3.Dot(y, z)) < RigidTolerance &&
                Mathf.Abs(Vector3.Dot(z, x)) < RigidTolerance;
        }
    }
}
