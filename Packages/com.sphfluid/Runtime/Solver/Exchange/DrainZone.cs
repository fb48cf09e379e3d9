using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A place where liquid leaves, as the GPU reads it: 64 bytes, <c>struct Drain</c> in Shaders/Solver/Cells/DrainParticles.compute.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct DrainZone
    {
        public const int Stride = 64;

        private Vector4 row0, row1, row2;
        private float length;
        private uint isBox;
        private uint count;
        private uint pad;

        /// <summary>The image of the cube from −1 to 1.</summary>
        /// <param name="cube">Maps the cube to simulation space [m].</param>
        public static DrainZone Box(in Matrix4x4 cube) => new DrainZone(cube, 0f, true);

        /// <summary>The image of a capsule of radius 1 along y; with length 0 a sphere.</summary>
        /// <param name="capsule">Maps the capsule to simulation space [m].</param>
        /// <param name="length">Half the distance of the centres of its ends, over its radius.</param>
        public static DrainZone Capsule(in Matrix4x4 capsule, float length) => new DrainZone(capsule, length, false);

        private DrainZone(in Matrix4x4 frame, float length, bool isBox)
        {
            bool exists = AffineMath.TryInvert(frame, out Matrix4x4 inverse);
            row0 = exists ? inverse.GetRow(0) : new Vector4(0f, 0f, 0f, 2f); // nobody is inside one without volume
            row1 = exists ? inverse.GetRow(1) : Vector4.zero;
            row2 = exists ? inverse.GetRow(2) : Vector4.zero;
            this.length = length;
            this.isBox = isBox ? 1u : 0u;
            count = 0u;
            pad = 0u;
        }

        /// <summary>A box around it [m]; without a volume a point.</summary>
        public readonly Bounds Bounds
        {
            get
            {
                var toZone = Matrix4x4.identity;
                toZone.SetRow(0, row0);
                toZone.SetRow(1, row1);
                toZone.SetRow(2, row2);
                if (!AffineMath.TryInvert(toZone, out Matrix4x4 frame)) return default;
                float high = isBox != 0u ? 1f : 1f + length;
                Vector3 x = frame.GetColumn(0), y = high * frame.GetColumn(1), z = frame.GetColumn(2);
                Vector3 extents = Vector3.zero;
                for (int axis = 0; axis < 3; axis++) extents[axis] = Mathf.Abs(x[axis]) + Mathf.Abs(y[axis]) + Mathf.Abs(z[axis]);
                return new Bounds(frame.GetColumn(3), 2f * extents);
            }
        }

        /// <summary>The same, counting what leaves for a source.</summary>
        internal readonly DrainZone CountedAt(int place)
        {
            DrainZone zone = this;
            zone.count = (uint)place;
            return zone;
        }
    }

    /// <summary>Whom a step loses.</summary>
    internal struct DrainBatch
    {
        /// <summary><see cref="DrainZone"/> each, one element or more.</summary>
        public GraphicsBuffer Zones;

        /// <summary>Counts of all sources.</summary>
        public GraphicsBuffer Counts;

        /// <summary>For the search for the oldest: 258 numbers, the first 256 zero.</summary>
        public GraphicsBuffer Ages;

        /// <summary><see cref="IdRange"/> each: the number of ranges, and behind it the ranges whose particles' time is over.</summary>
        public GraphicsBuffer Expired;

        /// <summary>Number of drains.</summary>
        public int Count;

        /// <summary>
        /// Whether the oldest leave where the liquid would have more than <see cref="MostParticles"/> with <see cref="Births"/>.
        /// </summary>
        public bool Recycles;

        public int Births, MostParticles;

        /// <summary>Number that the next particle gets.</summary>
        public uint NextId;

        /// <summary>Place of the count of those in <see cref="Counts"/>.</summary>
        public int RecycledCount;
    }
}
