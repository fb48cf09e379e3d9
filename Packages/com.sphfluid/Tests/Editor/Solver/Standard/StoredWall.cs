using System.Linq;
using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What GatherWalls stores of a particle's walls, seen from a place of the particle.</summary>
    internal readonly struct StoredWall
    {
        // PackedWall of NearWall.hlsl.
        [StructLayout(LayoutKind.Sequential)]
        public struct Packed
        {
            public uint Normal0;
            public float Offset0;
            public uint Plane0;
            public uint Normal1;
            public float Offset1;
            public uint Plane1;
            public uint Normal2;
            public float Offset2;
            public uint Plane2;
            public uint VelocityXY, VelocityZ;
        }

        readonly Packed packed;
        readonly Vector3 position;
        readonly FluidSolverSettings settings;

        public StoredWall(Packed packed, Vector3 position, FluidSolverSettings settings)
        {
            this.packed = packed;
            this.position = position;
            this.settings = settings;
        }

        // Of the first plane; the distance in metres.
        public Vector3 Normal => Octahedral(packed.Normal0);
        public double Distance => Away(position, 0);
        public float Approach => Half(packed.Plane0 >> 16);
        public Vector3 Velocity => new Vector3(Half(packed.VelocityXY), Half(packed.VelocityXY >> 16), Half(packed.VelocityZ >> 16));
        public uint Flags => packed.VelocityZ & 63u;
        public uint Friction => (packed.VelocityZ >> 6) & 1023u;
        public double Value => packed.Plane0 == 0u ? 0.0 : ValueAt(position);

        public double Gradient(int axis)
        {
            const double step = 1e-5;
            var e = new Double3(axis == 0 ? step : 0, axis == 1 ? step : 0, axis == 2 ? step : 0);
            return packed.Plane0 == 0u ? 0.0 : (ValueAt((Double3)position + e) - ValueAt((Double3)position - e)) / (2.0 * step);
        }

        double ValueAt(Double3 x)
        {
            double open = 1.0;
            uint[] planes = { packed.Plane0, packed.Plane1, packed.Plane2 };
            for (int k = 0; k < 3; k++)
                open *= 1.0 - (planes[k] & 0xffffu) / 65535.0 * StandardReference.Mirror(Away(x, k), settings.SupportRadius, settings.Spacing);
            return 1.0 - open;
        }

        double Away(Double3 x, int k)
        {
            Vector3 n = Octahedral(k == 0 ? packed.Normal0 : k == 1 ? packed.Normal1 : packed.Normal2);
            return x.X * n.x + x.Y * n.y + x.Z * n.z - (k == 0 ? packed.Offset0 : k == 1 ? packed.Offset1 : packed.Offset2);
        }

        static float Half(uint bits) => Mathf.HalfToFloat((ushort)bits);

        static Vector3 Octahedral(uint bits)
        {
            float x = (short)bits / 32767f, y = (short)(bits >> 16) / 32767f, z = 1f - Mathf.Abs(x) - Mathf.Abs(y);
            if (z < 0f) (x, y) = ((1f - Mathf.Abs(y)) * (x < 0f ? -1f : 1f), (1f - Mathf.Abs(x)) * (y < 0f ? -1f : 1f));
            return new Vector3(x, y, z).normalized;
        }

        /// <summary>The walls of each particle in the order of the last sort.</summary>
        public static StoredWall[] Read(StandardState state)
        {
            int count = state.ParticleCount;
            uint[] slots = GpuTest.Read<uint>(state.Walls.WallSlot, count);
            Packed[] packed = GpuTest.Read<Packed>(state.Walls.NearWalls, count);
            Vector4[] positions = GpuTest.Read<Vector4>(state.Buffers.Positions, count);
            return Enumerable.Range(0, count).Select(i =>
                new StoredWall(slots[i] == 0u ? default : packed[slots[i] - 1], positions[i], state.Settings)).ToArray();
        }
    }
}
