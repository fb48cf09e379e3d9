using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>
    /// The measured liquid: ¼ m³ of water as a block against one wall of a 1 m cube, a dam that has just broken. Its volume does not
    /// depend on the number of particles; the spacing does. Every sample starts from one saved state.
    /// </summary>
    internal sealed class BenchLiquid : IDisposable
    {
        /// <summary>Edge of the domain [m].</summary>
        public const float Edge = 1f;

        /// <summary>Steps from the block to the saved state: a tenth of a second of fall, at 16,384 to 65,536 particles.</summary>
        public const int SettleSteps = 100;

        private const double Volume = 0.25;
        private readonly BenchMesh mesh;

        public BenchLiquid(FluidShaderSet shaders, BenchSolver kind, int count)
        {
            FluidParticle[] block = Block(count, kind.HasMesh, out float spacing, out float height);
            Solver = new FluidSolver(kind.Settings(spacing, height), shaders, block);
            if (!kind.HasMesh) return;
            mesh = new BenchMesh(Solver.Settings);
            mesh.GiveTo(Solver);
        }

        public FluidSolver Solver { get; }

        /// <summary>Number of triangles in the liquid.</summary>
        public int TriangleCount => mesh?.TriangleCount ?? 0;

        /// <summary>Steps recorded of those to the saved state.</summary>
        public int SettledSteps { get; private set; }

        /// <summary>What samples start from: settled by <see cref="Settle"/>, or another liquid's.</summary>
        public BenchState State { get; set; }

        /// <summary>A marching-cubes grid over the domain.</summary>
        public static SurfaceGrid SurfaceGrid(int cells) => new SurfaceGrid(Vector3.one * (-0.5f * Edge), Vector3.one * Edge, cells);

        /// <summary>Records some of the steps to the saved state; false when all are done and the state is saved.</summary>
        public bool Settle(CommandBuffer cmd, int steps)
        {
            if (SettledSteps == SettleSteps)
            {
                var particles = new FluidParticle[Solver.ParticleCount];
                Solver.Particles.GetData(particles);
                State = new BenchState(particles);
                return false;
            }
            steps = Math.Min(steps, SettleSteps - SettledSteps);
            Solver.RecordSteps(cmd, steps);
            SettledSteps += steps;
            if (SettledSteps == SettleSteps) Solver.RecordNeighbourSetup(cmd); // gives out the particles
            return true;
        }

        /// <summary>Puts the saved state back. What the GPU still has to do with the old one is done first.</summary>
        public void Restore() => Solver.SetParticles(State.Particles);

        public void Dispose()
        {
            Solver.Dispose();
            mesh?.Dispose();
        }

        /// <summary>Spacing of that many particles, and about the height of their block [m].</summary>
        internal static void Sizes(int count, out float spacing, out float height)
        {
            spacing = (float)Math.Pow(Volume / count, 1.0 / 3.0);
            height = 0.5f * Edge;
        }

        /// <summary>
        /// Exactly <paramref name="count"/> particles, layer by layer from the floor; the top layer may be partly filled.
        /// </summary>
        internal static FluidParticle[] Block(int count, bool roundMesh, out float spacing, out float height)
        {
            double dx = Math.Pow(Volume / count, 1.0 / 3.0);
            int across = Math.Max(1, (int)(0.5 * Edge / dx + 1e-3));
            int deep = Math.Max(1, (int)(Edge / dx + 1e-3));
            var particles = new FluidParticle[count];
            spacing = (float)dx;
            int filled = 0, site = 0;
            for (; filled < count; site++)
            {
                int x = site % across, z = site / across % deep, y = site / (across * deep);
                Vector3 position = new Vector3(x + 0.5f, y + 0.5f, z + 0.5f) * spacing - Vector3.one * (0.5f * Edge);
                if (roundMesh && BenchMesh.Overlaps(position, spacing)) continue;
                particles[filled] = new FluidParticle(position, Vector3.zero, (uint)filled);
                filled++;
            }
            height = (float)(dx * ((site - 1) / (across * deep) + 1));
            return particles;
        }
    }
}
