using System;
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
            public uint Face;
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
        public Vector3 Face => Octahedral(packed.Face);
        public float Approach => Half(packed.Plane0 >> 16);
        public Vector3 Velocity => new Vector3(Half(packed.VelocityXY), Half(packed.VelocityXY >> 16), Half(packed.VelocityZ >> 16));
        public uint Flags => packed.VelocityZ & 63u;
        public uint Friction => (packed.VelocityZ >> 6) & 1023u;
        public double Value => packed.Plane0 == 0u ? 0.0 : ValueAt(position);

        public double Gradient(int axis)
        {
            const double step = 1e-7;
            var e = new Double3(axis == 0 ? step : 0, axis == 1 ? step : 0, axis == 2 ? step : 0);
            return packed.Plane0 == 0u ? 0.0 : (ValueAt((Double3)position + e) - ValueAt((Double3)position - e)) / (2.0 * step);
        }

        // Each plane's part is what those before it leave in sight.
        double ValueAt(Double3 x)
        {
            double open = 1.0;
            uint[] planes = { packed.Plane0, packed.Plane1, packed.Plane2 };
            for (int k = 0; k < 3; k++)
            {
                double part = (planes[k] & 0xffffu) / 65535.0 * StandardReference.Mirror(Away(x, k), settings.SupportRadius, settings.Spacing);
                for (int before = 0; before < k; before++) part *= 1.0 - HiddenBy(before, k, x);
                open *= 1.0 - part;
            }
            return 1.0 - open;
        }

        double HiddenBy(int before, int plane, Double3 x) =>
            Math.Min(Math.Max(Double3.Dot(NormalOf(before), NormalOf(plane)) * Away(x, plane) / Math.Max(Away(x, before), 1e-6 * settings.Spacing), 0.0), 1.0);

        Double3 NormalOf(int k) => Octahedral(k == 0 ? packed.Normal0 : k == 1 ? packed.Normal1 : packed.Normal2);

        // Of the second plane by the first, 0 to 1.
        public double Hidden => packed.Plane1 == 0u ? 0.0 : HiddenBy(0, 1, position);

        double Away(Double3 x, int k) => Double3.Dot(x, NormalOf(k)) - (k == 0 ? packed.Offset0 : k == 1 ? packed.Offset1 : packed.Offset2);

        static float Half(uint bits) => Mathf.HalfToFloat((ushort)bits);

        static Vector3 Octahedral(uint bits)
        {
            float x = (short)bits / 32767f, y = (short)(bits >> 16) / 32767f, z = 1f - Mathf.Abs(x) - Mathf.Abs(y);
            if (z < 0f) (x, y) = ((1f - Mathf.Abs(y)) * (x < 0f ? -1f : 1f), (1f - Mathf.Abs(x)) * (y < 0f ? -1f : 1f));
            return new Vector3(x, y, z).normalized;
        }

        static uint OfOctahedral(Vector3 n)
        {
            n /= Mathf.Abs(n.x) + Mathf.Abs(n.y) + Mathf.Abs(n.z);
            if (n.z < 0f) (n.x, n.y) = ((1f - Mathf.Abs(n.y)) * (n.x < 0f ? -1f : 1f), (1f - Mathf.Abs(n.x)) * (n.y < 0f ? -1f : 1f));
            return (ushort)(short)Mathf.Round(32767f * n.x) | (uint)(ushort)(short)Mathf.Round(32767f * n.y) << 16;
        }

        /// <summary>What GatherWalls stores at the start of a step of a frame.</summary>
        public static StoredWall[] Gather(StandardState state, int step, int steps)
        {
            state.BeginBodyStep(step, steps, state.Settings.TimeStep);
            FluidShaderSet set = TestShaders.CreateSet();
            try
            {
                GpuTest.Run(cmd => new GatherWallsPass(set).Record(cmd, state, state.Buffers.Positions));
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(set);
            }
            return Read(state);
        }

        /// <summary>Up to three planes as GatherWalls stores them, at rest and without friction of their own.</summary>
        /// <param name="position">Where the particle is.</param>
        /// <param name="solid">How much of each plane is there, 0 to 1; 0 only hides what is behind.</param>
        /// <param name="areFaces">Whether they are faces, not beyond edges.</param>
        /// <param name="planes">Unit normals towards the particle and distances [m].</param>
        public static Packed Pack(Vector3 position, float solid, bool areFaces, params (Vector3 Normal, float Distance)[] planes)
        {
            (uint, float, uint) Plane(int k)
            {
                if (k >= planes.Length) return (0u, -1e30f, 0u);
                uint normal = OfOctahedral(planes[k].Normal);
                return (normal, Vector3.Dot(Octahedral(normal), position) - planes[k].Distance, (uint)Mathf.Round(65535f * solid));
            }
            var packed = new Packed { VelocityZ = areFaces ? (1u << planes.Length) - 1u : 0u };
            (packed.Normal0, packed.Offset0, packed.Plane0) = Plane(0);
            (packed.Normal1, packed.Offset1, packed.Plane1) = Plane(1);
            (packed.Normal2, packed.Offset2, packed.Plane2) = Plane(2);
            return packed;
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
