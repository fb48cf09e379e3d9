using System;
using System.Linq;
using System.Security.Cryptography;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// A simulation's particles at one moment, without those that left the domain, read back from the GPU and ordered by id: SI units.
    /// Reading waits for the GPU; it is for tools and tests.
    /// </summary>
    public sealed class FluidSnapshot
    {
        private FluidSnapshot(int count)
        {
            Ids = new uint[count];
            LocalPositions = new Vector3[count];
            Velocities = new Vector3[count];
            Densities = new float[count];
            Pressures = new float[count];
        }

        /// <summary>Number of particles.</summary>
        public int Count => Ids.Length;

        /// <summary>Particle ids, ascending.</summary>
        public uint[] Ids { get; }

        /// <summary>Positions in the simulation's space [m]: the domain is the box of its size about the origin.</summary>
        public Vector3[] LocalPositions { get; }

        /// <summary>From the simulation's space to world space.</summary>
        public Matrix4x4 LocalToWorld { get; private set; }

        /// <summary>Velocities at the time of the positions, in world space [m/s].</summary>
        public Vector3[] Velocities { get; }

        /// <summary>Densities [kg/m³].</summary>
        public float[] Densities { get; }

        /// <summary>Pressures [Pa].</summary>
        public float[] Pressures { get; }

        /// <summary>SHA-256 over ids, positions and velocities as the GPU holds them: equal for bit-equal states.</summary>
        public string Hash { get; private set; }

        /// <summary>Position of the particle at an index in world space.</summary>
        internal WorldPoint PositionOf(int index) => new WorldPoint(LocalToWorld, LocalPositions[index]);

        /// <summary>Reads the particles of a running simulation.</summary>
        /// <exception cref="InvalidOperationException">The simulation is not running.</exception>
        public static FluidSnapshot Read(FluidSimulation simulation)
        {
            FluidSolver solver = simulation.Solver;
            if (solver == null)
            {
                throw new InvalidOperationException($"'{simulation.name}' is not running, so it has no particles to read. Start it first.");
            }
            return Read(solver, simulation.LocalToWorld);
        }

        /// <summary>Reads the particles of a solver; world space is the simulation's own.</summary>
        public static FluidSnapshot Read(FluidSolver solver) => Read(solver, Matrix4x4.identity);

        private static FluidSnapshot Read(FluidSolver solver, Matrix4x4 localToWorld)
        {
            GpuWork.Submit("Fluid Snapshot", cmd => solver.RecordNeighbourSetup(cmd));
            var particles = new FluidParticle[solver.ParticleCount];
            var densities = new float[particles.Length];
            var pressures = new float[particles.Length];
            solver.Particles.GetData(particles);
            solver.Density.GetData(densities);
            solver.Pressure.GetData(pressures);
            return FromParticles(particles, densities, pressures, localToWorld);
        }

        internal static FluidSnapshot FromParticles(FluidParticle[] particles, float[] densities, float[] pressures, Matrix4x4 localToWorld)
        {
            int[] order = Enumerable.Range(0, particles.Length).Where(i => !particles[i].IsRemoved).ToArray();
            Array.Sort(order, (a, b) => particles[a].Id.CompareTo(particles[b].Id));

            var snapshot = new FluidSnapshot(order.Length) { LocalToWorld = localToWorld };
            for (int i = 0; i < order.Length; i++)
            {
                FluidParticle particle = particles[order[i]];
                snapshot.Ids[i] = particle.Id;
                snapshot.LocalPositions[i] = particle.Position;
                snapshot.Velocities[i] = localToWorld.MultiplyVector(VelocityOf(particle));
                snapshot.Densities[i] = densities[order[i]];
                snapshot.Pressures[i] = pressures[order[i]];
            }
            snapshot.Hash = HashOf(particles, order);
            return snapshot;
        }

        // Positions are half a step ahead of VelT0 and a whole one ahead of VelT1: what the last force did between the two is done once
        // more. From v(t-dt) = 1 and v(t-dt/2) = 1.5, a = 1/dt: v(t) = 2. A component that a face of the domain stopped is zero.
        private static Vector3 VelocityOf(in FluidParticle particle)
        {
            Vector3 velocity = particle.VelT0;
            for (int axis = 0; axis < 3; axis++) velocity[axis] = velocity[axis] == 0f ? 0f : 2f * velocity[axis] - particle.VelT1[axis];
            return velocity;
        }

        private static string HashOf(FluidParticle[] particles, int[] order)
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

        private static void Put(byte[] bytes, ref int at, Vector3 value)
        {
            Put(bytes, ref at, unchecked((uint)BitConverter.SingleToInt32Bits(value.x)));
            Put(bytes, ref at, unchecked((uint)BitConverter.SingleToInt32Bits(value.y)));
            Put(bytes, ref at, unchecked((uint)BitConverter.SingleToInt32Bits(value.z)));
        }

        private static void Put(byte[] bytes, ref int at, uint value)
        {
            for (int shift = 0; shift < 32; shift += 8) bytes[at++] = (byte)(value >> shift);
        }
    }
}
