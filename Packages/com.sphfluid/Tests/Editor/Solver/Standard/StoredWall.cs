using System;
using System.Linq;
using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What GatherWalls stores of a particle's walls, seen from a place of the particle.</summary>
    internal readonly struct StoredWall
    {
        // PackedWall of MeshWalls.hlsl.
        [StructLayout(LayoutKind.Sequential)]
        public struct Packed
        {
            public uint Normal0;
            public float Offset0;
            public uint Approach0;
            public uint Normal1;
            public float Offset1;
            public uint Approach1;
            public uint Normal2;
            public float Offset2;
            public uint Approach2;
            public uint VelocityXY, VelocityZ;
            public Vector3 Origin;
            public float Share;
            public uint HessianXXYY, HessianZZYZ, HessianZXXY;
            public Vector3 Push0, Push1, Push2;
        }

        private readonly Packed packed;
        private readonly Vector3 position;
        private readonly FluidSolverSettings settings;

        public StoredWall(Packed packed, Vector3 position, FluidSolverSettings settings, bool isBrief = false)
        {
            IsBrief = isBrief;
            this.packed = packed;
            this.position = position;
            this.settings = settings;
        }

        // Of the first plane; the distance in metres.
        public Vector3 Normal => Octahedral(packed.Normal0);
        public double Distance => Away(position, 0);
        public float Approach => Half(packed.Approach0);
        public Vector3 Velocity => new Vector3(Half(packed.VelocityXY), Half(packed.VelocityXY >> 16), Half(packed.VelocityZ >> 16));
        public uint Flags => packed.VelocityZ & 63u;
        public uint Friction => (packed.VelocityZ >> 6) & 1023u;
        public double Value => packed.Share + Double3.Dot(Push + 0.5 * Turned, Gone);

        /// <summary>Whether it serves for a short way only.</summary>
        public bool IsBrief { get; }

        /// <summary>The same, seen from a place to which the particle has gone since.</summary>
        public StoredWall From(Vector3 place) => new StoredWall(packed, place, settings, IsBrief);

        public double Gradient(int axis) => (Push + Turned)[axis];

        public Double3 Push => (Double3)packed.Push0 + (Double3)packed.Push1 + (Double3)packed.Push2;

        // Of the first plane's wall.
        public Vector3 FirstPush => packed.Push0;

        private Double3 Gone => (Double3)position - (Double3)packed.Origin;

        // What the Hessian adds to the gradient.
        private Double3 Turned
        {
            get
            {
                double scale = 1.0 / ((double)settings.SupportRadius * settings.SupportRadius);
                double xx = Half(packed.HessianXXYY), yy = Half(packed.HessianXXYY >> 16), zz = Half(packed.HessianZZYZ),
                    yz = Half(packed.HessianZZYZ >> 16);
                double zx = Half(packed.HessianZXXY), xy = Half(packed.HessianZXXY >> 16);
                Double3 d = Gone;
                return scale * new Double3(xx * d.X + xy * d.Y + zx * d.Z, xy * d.X + yy * d.Y + yz * d.Z, zx * d.X + yz * d.Y + zz * d.Z);
            }
        }

        private Double3 NormalOf(int k) => Octahedral(k == 0 ? packed.Normal0 : k == 1 ? packed.Normal1 : packed.Normal2);

        private double Away(Double3 x, int k) => Double3.Dot(x, NormalOf(k)) -
            (k == 0 ? packed.Offset0 : k == 1 ? packed.Offset1 : packed.Offset2);

        private static float Half(uint bits) => Mathf.HalfToFloat((ushort)bits);

        private static Vector3 Octahedral(uint bits)
        {
            float x = (short)bits / 32767f, y = (short)(bits >> 16) / 32767f, z = 1f - Mathf.Abs(x) - Mathf.Abs(y);
            if (z < 0f) (x, y) = ((1f - Mathf.Abs(y)) * (x < 0f ? -1f : 1f), (1f - Mathf.Abs(x)) * (y < 0f ? -1f : 1f));
            return new Vector3(x, y, z).normalized;
        }

        private static uint OfOctahedral(Vector3 n)
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
        /// <param name="areFaces">Whether they are faces, not beyond edges.</param>
        /// <param name="share">Of the kernel, behind them.</param>
        /// <param name="pushes">What each has of the gradient of that [1/m].</param>
        /// <param name="planes">Unit normals towards the particle and distances [m].</param>
        public static Packed Pack(Vector3 position, bool areFaces, float share, Vector3[] pushes,
            params (Vector3 Normal, float Distance)[] planes)
        {
            (uint, float, uint) Plane(int k)
            {
                if (k >= planes.Length) return (0u, -1e30f, 0u);
                uint normal = OfOctahedral(planes[k].Normal);
                return (normal, Vector3.Dot(Octahedral(normal), position) - planes[k].Distance, 0u);
            }
            Vector3 Push(int k) => pushes != null && k < pushes.Length ? pushes[k] : Vector3.zero;
            var packed = new Packed
            {
                VelocityZ = areFaces ? (1u << planes.Length) - 1u : 0u, Origin = position, Share = share,
                Push0 = Push(0), Push1 = Push(1), Push2 = Push(2)
            };
            (packed.Normal0, packed.Offset0, packed.Approach0) = Plane(0);
            (packed.Normal1, packed.Offset1, packed.Approach1) = Plane(1);
            (packed.Normal2, packed.Offset2, packed.Approach2) = Plane(2);
            return packed;
        }

        /// <summary>The walls of each particle in the order of the last sort.</summary>
        public static StoredWall[] Read(StandardState state)
        {
            int count = state.ParticleCount;
            uint[] slots = state.List.WallSlot.Read<uint>(count);
            Packed[] packed = GpuTest.Read<Packed>(state.Walls.NearWalls, count);
            Vector4[] positions = GpuTest.Read<Vector4>(state.Buffers.Positions, count);
            Vector4[] gaps = state.Walls.WallGap.Read<Vector4>(count);
            return Enumerable.Range(0, count).Select(i =>
                new StoredWall(slots[i] == 0u ? default : packed[slots[i] - 1], positions[i], state.Settings,
                    BitConverter.SingleToInt32Bits(gaps[i].w) < 0)).ToArray();
        }
    }
}
