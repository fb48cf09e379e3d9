using System;
using System.Security.Cryptography;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>
    /// A simulation's particles at one moment, read back from the GPU and ordered by id: world space, SI units. Reading
    /// waits for the GPU; it is for tools and tests.
    /// </summary>
    public sealed class FluidSnapshot
    {
        FluidSnapshot(int count)
        {
            Ids = new uint[count];
            Positions = new Vector3[count];
            LocalPositions = new Vector3[count];
            Velocities = new Vector3[count];
            Densities = new float[count];
            Pressures = new float[count];
        }

        /// <summary>Number of particles.</summary>
        public int Count => Ids.Length;

        /// <summary>Particle ids, ascending.</summary>
        public uint[] Ids { get; }

        /// <summary>Positions in world space [m].</summary>
        public Vector3[] Positions { get; }

        /// <summary>Positions in the simulation's space [m]: the domain is the box of its size about the origin.</summary>
        public Vector3[] LocalPositions { get; }

        /// <summary>Velocities at the time of the positions, in world space [m/s].</summary>
        public Vector3[] Velocities { get; }

        /// <summary>Densities [kg/m³].</summary>
        public float[] Densities { get; }

        /// <summary>Pressures [Pa].</summary>
        public float[] Pressures { get; }

        /// <summary>SHA-256 over ids, positions and velocities as the GPU holds them: equal for bit-equal states.</summary>
        public string Hash { get; private set; }

        /// <summary>Reads the particles of a running simulation.</summary>
        /// <exception cref="InvalidOperationException">The simulation is not running.</exception>
        public static FluidSnapshot Read(FluidSimulation simulation)
        {
            FluidSolver solver = simulation.Solver;
            if (solver == null)
                throw new InvalidOperationException($"'{simulation.name}' is not running, so it has no particles to read. Start it first.");
            using (var cmd = new CommandBuffer { name = "Fluid Snapshot" })
            {
                solver.RecordNeighbourSetup(cmd);
                Graphics.ExecuteCommandBuffer(cmd);
            }
            var particles = new FluidParticle[solver.ParticleCount];
            var densities = new float[particles.Length];
            var pressures = new float[particles.Length];
            solver.Particles.GetData(particles);
            solver.Density.GetData(densities);
            solver.Pressure.GetData(pressures);
            return FromParticles(particles, densities, pressures, simulation.LocalToWorld);
        }

        internal static FluidSnapshot FromParticles(FluidParticle[] particles, float[] densities, float[] pressures, Matrix4x4 localToWorld)
        {
            var order = new int[particles.Length];
            for (int i = 0; i < order.Length; i++)
                order[i] = i;
            Array.Sort(order, (a, b) => particles[a].Id.CompareTo(particles[b].Id));

            var snapshot = new FluidSnapshot(particles.Length);
            for (int i = 0; i < order.Length; i++)
            {
                FluidParticle particle = particles[order[i]];
                snapshot.Ids[i] = particle.Id;
                snapshot.LocalPositions[i] = particle.Position;
                snapshot.Positions[i] = localToWorld.MultiplyPoint3x4(particle.Position);
                snapshot.Velocities[i] = localToWorld.MultiplyVector(particle.VelT1);
                snapshot.Densities[i] = densities[order[i]];
                snapshot.Pressures[i] = pressures[order[i]];
            }
            snapshot.Hash = HashOf(particles, order);
            return snapshot;
        }

        static string HashOf(FluidParticle[] particles, int[] order)
        {
            var bytes = new byte[order.Length * 40];
            int at = 0;
            foreach (int index in order)
            {
                FluidParticle p = particles[index];
                Put(bytes, ref at, p.Id);
                Put(bytes, ref at, p.Position);
                Put(bytes, ref at, p.VelT0);
                Put(bytes, ref at, p.VelT1);
            }
            using (SHA256 sha = SHA256.Create())
                return BitConverter.ToString(sha.ComputeHash(bytes)).Replace("-", "").ToLowerInvariant();
        }

        static void Put(byte[] bytes, ref int at, Vector3 value)
        {
            Put(bytes, ref at, unchecked((uint)BitConverter.SingleToInt32Bits(value.x)));
            Put(bytes, ref at, unchecked((uint)BitConverter.SingleToInt32Bits(value.y)));
            Put(bytes, ref at, unchecked((uint)BitConverter.SingleToInt32Bits(value.z)));
        }

        static void Put(byte[] bytes, ref int at, uint value)
        {
            for (int shift = 0; shift < 32; shift += 8)
                bytes[at++] = (byte)(value >> shift);
        }
    }
}
