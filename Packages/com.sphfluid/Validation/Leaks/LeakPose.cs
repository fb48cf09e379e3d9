using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Where a rigid surface is: rotated, then moved. Simulation space.</summary>
    readonly struct LeakPose
    {
        public LeakPose(Vector3 position, Quaternion rotation)
        {
            Position = position;
            Rotation = rotation;
        }

        /// <summary>Where its origin is [m].</summary>
        public Vector3 Position { get; }

        public Quaternion Rotation { get; }

        public static LeakPose Rest => new LeakPose(Vector3.zero, Quaternion.identity);

        /// <summary>A place of simulation space in the surface's own.</summary>
        public Vector3 ToSurface(Vector3 place) => Quaternion.Inverse(Rotation) * (place - Position);

        /// <summary>A place of the surface's own space in simulation space.</summary>
        public Vector3 ToSimulation(Vector3 place) => Rotation * place + Position;

        /// <summary>Part of the way from one to another, as bodies go it within a frame.</summary>
        public static LeakPose Between(LeakPose a, LeakPose b, float part) =>
            new LeakPose(Vector3.Lerp(a.Position, b.Position, part), Quaternion.Lerp(a.Rotation, b.Rotation, part));
    }
}
