using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid
{
    /// <summary>A triangle in simulation space [m]; mirrored by CollisionTriangle in Shaders/Collision/CollisionTypes.hlsl.</summary>
    /// <remarks>Cross(B − A, C − A) points out of the solid, as Unity's clockwise front faces do.</remarks>
    [StructLayout(LayoutKind.Sequential)]
    internal struct CollisionTriangle
    {
        public const int Stride = 48;

        public Vector3 A;
        public float PadA;
        public Vector3 B;
        public float PadB;
        public Vector3 C;
        public float PadC;
    }

    /// <summary>Range of triangles of one collider with their bounds [m]; mirrored by CollisionCollider in CollisionTypes.hlsl.</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct CollisionCollider
    {
        public const int Stride = 32;

        /// <summary>Bit of <see cref="TriangleCount"/>: the mesh encloses a volume.</summary>
        public const uint ClosedBit = 0x80000000u;

        /// <summary>Bits of <see cref="TriangleCount"/> that hold the count.</summary>
        public const uint CountMask = 0x3fffffffu;

        public Vector3 BoundsMin;
        public uint FirstTriangle;
        public Vector3 BoundsMax;
        public uint TriangleCount;
    }
}
