using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>
    /// The measured liquid: ¼ m³ of water as a block against one wall of a 1 m cube, a dam that has just broken. Its volume does not
    /// depend on the number of particles; the spacing does. Every sample starts from one saved state.
    /// </summary>
    sealed class BenchLiquid : IDisposable
    {
        /// <summary>Edge of the domain [m].</summary>
        public const float Edge = 1f;

        /// <summary>Steps from the block to the saved state: a tenth of a second of fall, at 16,384 to 65,536 particles.</summary>
        public const int SettleSteps = 100;

        const double Volume = 0.25;
        readonly FluidParticle[] saved;

        public BenchLiquid(FluidShaderSet shaders, int count)
        {
            FluidParticle[] block = Block(count, out float spacing, out float height);
            FluidRuleInput rules = FluidRuleInput.Water;
            rules.DomainSize = Vector3.one * Edge;
            rules.Spacing = spacing;
            rules.LiquidHeight = height;
            rules.LiquidDepth = height;
            Solver = new FluidSolver(FluidSolverSettings.FromRules(rules), shaders, block);
            saved = new FluidParticle[count];
        }

        public FluidSolver Solver { get; }

        /// <summary>Steps recorded of those to the saved state.</summary>
        public int SettledSteps { get; private set; }

        /// <summary>Mean number of other particles within R in the saved state.</summary>
        public double NeighboursMean { get; private set; }

        /// <summary>Records some of the steps to the saved state; false when all are done and the state is saved.</summary>
        public bool Settle(CommandBuffer cmd, int steps)
        {
            if (SettledSteps == SettleSteps)
            {
                Save();
                return false;
            }
            steps = Math.Min(steps, SettleSteps - SettledSteps);
            Solver.RecordSteps(cmd, steps);
            SettledSteps += steps;
            return true;
        }

        /// <summary>Puts the saved state back. What the GPU still has to do with the old one is done first.</summary>
        public void Restore() => Solver.SetParticles(saved);

        public void Dispose() => Solver.Dispose();

        /// <summary>Exactly <paramref name="count"/> particles, layer by layer from the floor; the top layer may be partly filled.</summary>
        internal static FluidParticle[] Block(int count, out float spacing, out float height)
        {
            double dx = Math.Pow(Volume / count, 1.0 / 3.0);
            int across = Math.Max(1, (int)(0.5 * Edge / dx + 1e-3));
            int deep = Math.Max(1, (int)(Edge / dx + 1e-3));
            var particles = new FluidParticle[count];
            for (int i = 0; i < count; i++)
            {
                int x = i % across, z = i / across % deep, y = i / (across * deep);
                var cell = new Vector3(x + 0.5f, y + 0.5f, z + 0.5f);
                particles[i] = new FluidParticle(cell * (float)dx - Vector3.one * (0.5f * Edge), Vector3.zero, (uint)i);
            }
            spacing = (float)dx;
            height = (float)(dx * ((count - 1) / (across * deep) + 1));
            return particles;
        }

        void Save()
        {
            Solver.Particles.GetData(saved);
            var positions = new Vector3[saved.Length];
            for (int i = 0; i < saved.Length; i++)
                positions[i] = saved[i].Position;
            NeighboursMean = NeighbourCount.Of(positions, Solver.Settings.SupportRadius).Mean;
        }
    }
}
