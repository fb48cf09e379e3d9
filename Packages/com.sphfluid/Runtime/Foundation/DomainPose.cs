using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// World space to simulation space. What is far from the world's origin is brought near the domain's before it is turned: at 10 km a
    /// number has steps of 1 mm, and each operation with such numbers would add its own.
    /// </summary>
    internal readonly struct DomainPose
    {
        private readonly Vector3 position; // m, world
        private readonly Matrix4x4 turn;

        /// <param name="position">World position of the domain [m].</param>
        /// <param name="turn">What is left to do from there.</param>
        public DomainPose(Vector3 position, in Matrix4x4 turn)
        {
            this.position = position;
            this.turn = turn;
        }

        /// <summary>Any map as a whole.</summary>
        public static implicit operator DomainPose(in Matrix4x4 map) => new DomainPose(Vector3.zero, map);

        /// <summary>As one matrix, with the steps that its numbers have.</summary>
        public static implicit operator Matrix4x4(in DomainPose pose) => pose * Matrix4x4.identity;

        /// <summary>A frame that leads to the world, leading to simulation space.</summary>
        public static Matrix4x4 operator *(in DomainPose pose, Matrix4x4 toWorld)
        {
            toWorld.m03 -= pose.position.x;
            toWorld.m13 -= pose.position.y;
            toWorld.m23 -= pose.position.z;
            return pose.turn * toWorld;
        }

        /// <summary>A place of the world [m].</summary>
        public Vector3 MultiplyPoint3x4(Vector3 place) => turn.MultiplyPoint3x4(place - position);

        /// <summary>A direction of the world.</summary>
        public Vector3 MultiplyVector(Vector3 direction) => turn.MultiplyVector(direction);
    }
}
