using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Where a surface is: scaled, rotated, scaled again by its parent, then moved. Simulation space.</summary>
    internal readonly struct LeakPose
    {
        private readonly Vector3? scale, parentScale;

        /// <param name="position">Where its origin is [m].</param>
        /// <param name="rotation">Of the object.</param>
        /// <param name="scale">Of the object; 1 without.</param>
        /// <param name="parentScale">Of the object that holds it: what is rotated below an uneven one is sheared; 1 without.</param>
        public LeakPose(Vector3 position, Quaternion rotation, Vector3? scale = null, Vector3? parentScale = null)
        {
            Position = position;
            Rotation = rotation;
            this.scale = scale;
            this.parentScale = parentScale;
        }

        /// <summary>Where its origin is [m].</summary>
        public Vector3 Position { get; }

        public Quaternion Rotation { get; }

        public Vector3 Scale => scale ?? Vector3.one;

        public Vector3 ParentScale => parentScale ?? Vector3.one;

        public static LeakPose Rest => new LeakPose(Vector3.zero, Quaternion.identity);

        /// <summary>A place of simulation space in the surface's own.</summary>
        public Vector3 ToSurface(Vector3 place) =>
            Divided(Quaternion.Inverse(Rotation) * Divided(place - Position, ParentScale), Scale);

        /// <summary>A place of the surface's own space in simulation space.</summary>
        public Vector3 ToSimulation(Vector3 place) =>
            Vector3.Scale(ParentScale, Rotation * Vector3.Scale(Scale, place)) + Position;

        /// <summary>Part of the motion from one to another, as rigid bodies go it within a frame.</summary>
        /// <exception cref="NotSupportedException">A scale changes: bodies then move otherwise, and only the end is known.</exception>
        public static LeakPose Between(LeakPose a, LeakPose b, float part)
        {
            if (part == 1f) return b;
            if (a.Scale != b.Scale || a.ParentScale != b.ParentScale || b.ParentScale != Vector3.one)
            {
                throw new NotSupportedException("The motion of a surface that stretches is known at the ends of frames only.");
            }
            return new LeakPose(Vector3.Lerp(a.Position, b.Position, part), Quaternion.Lerp(a.Rotation, b.Rotation, part), b.scale);
        }

        private static Vector3 Divided(Vector3 v, Vector3 by) => new Vector3(v.x / by.x, v.y / by.y, v.z / by.z);
    }
}
