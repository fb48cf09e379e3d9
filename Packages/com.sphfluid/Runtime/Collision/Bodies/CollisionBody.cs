using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A part of the scene in a frame of its own, in which its triangles rest, stretch or deform; mirrored by CollisionBody in
    /// Shaders/Collision/Bodies.hlsl. SI.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct CollisionBody
    {
        public const int Stride = 192;

        /// <summary>Bit of <see cref="Flags"/>: the poses differ, or will.</summary>
        public const uint Moves = 1u;

        /// <summary>Bit of <see cref="Flags"/>: scale or shear differ from those of the triangles.</summary>
        public const uint Stretches = 2u;

        /// <summary>Bits of <see cref="Flags"/> below the number of the rigid body that the liquid moves.</summary>
        public const int NumberShift = 8;

        public Quaternion Rotation0;
        public Quaternion Rotation1;
        public Vector3 Position0;
        public uint FirstCell;
        public Vector3 Position1;
        public uint Flags;
        public Vector3 GridOrigin;
        public float CellSide;
        public Vector3Int GridCounts;
        public uint BodyCount;
        public Vector3 BoundsMin;
        public float Friction;
        public Vector3 BoundsMax;
        public float PartsPerMetre;
        public Vector3 StretchDiagonal0;
        public Vector3 StretchShear0;
        public Vector3 StretchDiagonal1;
        public Vector3 StretchShear1;
        public uint EndTriangles;
        public Vector3 Unused;
    }

    /// <summary>A triangle of a body's frame [m]; mirrored by BodyTriangle in Shaders/Collision/Bodies.hlsl.</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct BodyTriangle
    {
        public const int Stride = 48;

        // A plane that float resolves: the area is no less than this part of the longest edge's square.
        private const double NeedleArea = 1e-3;

        public Vector3 A;
        public float NormalX;
        public Vector3 B;
        public float NormalY;
        public Vector3 C;
        public float NormalZ;

        /// <summary>Lowest corner of its box [m].</summary>
        public Vector3 Low => Vector3.Min(A, Vector3.Min(B, C));

        /// <summary>Highest corner of its box [m].</summary>
        public Vector3 High => Vector3.Max(A, Vector3.Max(B, C));

        /// <summary>Height of a point over its plane along the normal [m]; 0 of a needle.</summary>
        public double Height(Vector3 point) =>
            ((double)point.x - A.x) * NormalX + ((double)point.y - A.y) * NormalY + ((double)point.z - A.z) * NormalZ;

        /// <summary>A triangle with its unit normal; zero for a needle.</summary>
        public static BodyTriangle Create(Vector3 a, Vector3 b, Vector3 c)
        {
            double ux = (double)b.x - a.x, uy = (double)b.y - a.y, uz = (double)b.z - a.z;
            double vx = (double)c.x - a.x, vy = (double)c.y - a.y, vz = (double)c.z - a.z;
            double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
            double area = System.Math.Sqrt(nx * nx + ny * ny + nz * nz);
            double longest = System.Math.Max((b - a).sqrMagnitude, System.Math.Max((c - a).sqrMagnitude, (c - b).sqrMagnitude));
            double scale = area > NeedleArea * longest ? 1.0 / area : 0.0;
            return new BodyTriangle
            {
                A = a, B = b, C = c, NormalX = (float)(nx * scale), NormalY = (float)(ny * scale),
                NormalZ = (float)(nz * scale)
            };
        }
    }
}
