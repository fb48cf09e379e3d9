using System;
using System.Collections.Generic;
using System.IO;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Live particles by number, as a save holds them.</summary>
    internal static class SavedParticles
    {
        /// <summary>Waits for the GPU and reads the live particles of a liquid, the oldest first.</summary>
        public static FluidParticle[] Read(FluidSolver solver)
        {
            var particles = new List<FluidParticle>();
            FluidReports.TryReadParticles(solver, particles);
            FluidParticle[] sorted = particles.ToArray();
            Array.Sort(sorted, (a, b) => a.Id.CompareTo(b.Id));
            return sorted;
        }

        /// <summary>Writes particles; the second velocity only where a method has one of its own.</summary>
        public static void Save(SaveWriter writer, FluidParticle[] particles)
        {
            writer.WriteItems(Array.ConvertAll(particles, p => p.Id), particles.Length);
            writer.WriteItems(Array.ConvertAll(particles, p => p.Position), particles.Length);
            writer.WriteItems(Array.ConvertAll(particles, p => p.VelT0), particles.Length);
            bool differ = Array.Exists(particles, p => !p.VelT0.Equals(p.VelT1));
            writer.WriteItems(differ ? Array.ConvertAll(particles, p => p.VelT1) : Array.Empty<Vector3>(), differ ? particles.Length : 0);
        }

        /// <summary>Reads what <see cref="Save"/> wrote.</summary>
        /// <exception cref="InvalidDataException">The numbers of items differ.</exception>
        public static FluidParticle[] Load(SaveReader reader)
        {
            uint[] ids = reader.ReadItems<uint>();
            Vector3[] positions = reader.ReadItems<Vector3>(), velocities = reader.ReadItems<Vector3>(),
                others = reader.ReadItems<Vector3>();
            if (positions.Length != ids.Length || velocities.Length != ids.Length || others.Length != 0 && others.Length != ids.Length)
            {
                throw new InvalidDataException("its particles have not as many positions and velocities as numbers");
            }
            var particles = new FluidParticle[ids.Length];
            for (int i = 0; i < ids.Length; i++)
            {
                particles[i] = new FluidParticle(positions[i], velocities[i], ids[i]);
                if (others.Length > 0) particles[i].VelT1 = others[i];
            }
            return particles;
        }

        /// <summary>Writes what a correction adds to the densities, in the order of <see cref="Save"/>.</summary>
        public static void SaveOffsets(SaveWriter writer, FluidParticle[] particles) =>
            writer.WriteItems(Array.ConvertAll(particles, p => p.DensityOffset), particles.Length);

        /// <summary>Gives particles what <see cref="SaveOffsets"/> wrote.</summary>
        /// <exception cref="InvalidDataException">There are not as many.</exception>
        public static void LoadOffsets(SaveReader reader, FluidParticle[] particles)
        {
            float[] offsets = reader.ReadItems<float>();
            if (offsets.Length != particles.Length) throw new InvalidDataException("has not as many offsets of the density as particles");
            for (int i = 0; i < offsets.Length; i++) particles[i].DensityOffset = offsets[i];
        }
    }
}
