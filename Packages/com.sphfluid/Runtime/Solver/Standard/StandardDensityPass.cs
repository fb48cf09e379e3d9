using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Density by summation with the walls' share, and the pressure term.</summary>
    internal sealed class StandardDensityPass : ComputePass
    {
        private static readonly int DensityFactor = Id("_DensityFactor");
        private static readonly int InverseMoment = Id("_InverseMoment");
        private static readonly int SoundSpeedSquared = Id("_SoundSpeedSquared");
        private static readonly int Impact = Id("_Impact");
        private static readonly int SupportSquared = Id("_SupportSquared");
        private static readonly int Ahead = Id("_Ahead");
        private static readonly int Places = Id("_Places");

        private readonly ComputeKernel search, listed;

        public StandardDensityPass(FluidShaderSet shaders)
            : base(shaders, "StandardDensity")
        {
            search = Kernel();
            listed = Kernel("ListedDensity");
        }

        /// <summary>Sums over the cells around each particle of the last sort, and lists its neighbours.</summary>
        public void Record(CommandBuffer cmd, StandardState state)
        {
            using (Sample(cmd))
            {
                Bind(cmd, search, state);
                state.List.SetOut(cmd, search);
                search.SetFloat(cmd, Ahead, state.ListTime);
                search.Set(cmd, state.Buffers.Positions);
                search.Set(cmd, state.Buffers.Velocities);
                AwakeGroups.Dispatch(cmd, search, state);
            }
        }

        /// <summary>
        /// Sums over the neighbours that are listed already; who is behind a wall that bends is noted anew.
        /// </summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="state">The liquid.</param>
        /// <param name="places">Where the particles are, in the order of the last sort.</param>
        public void RecordListed(CommandBuffer cmd, StandardState state, FluidBuffer places)
        {
            using (Sample(cmd))
            {
                Bind(cmd, listed, state);
                state.List.SetOut(cmd, listed);
                listed.SetBuffer(cmd, Places, places);
                AwakeGroups.Dispatch(cmd, listed, state);
            }
        }

        private static void Bind(CommandBuffer cmd, ComputeKernel kernel, StandardState state)
        {
            FluidSolverSettings settings = state.Settings;
            CellBindings.SetSearch(cmd, kernel, state);
            CellBindings.SetWalls(cmd, kernel, state);
            kernel.SetFloat(cmd, SupportSquared, settings.SupportRadius * settings.SupportRadius);
            kernel.SetFloat(cmd, DensityFactor, (float)(settings.ParticleMass * WendlandKernel.Factor(settings.SupportRadius)));
            kernel.SetFloat(cmd, InverseMoment, (float)(1.0 / WendlandKernel.LatticeMoment(settings.SupportRadius / settings.Spacing)));
            kernel.SetFloat(cmd, SoundSpeedSquared, settings.SoundSpeed * settings.SoundSpeed);
            kernel.SetVector(cmd, Impact, state.Impact);
            CellBindings.SetSuction(cmd, kernel, settings);
            kernel.SetOut(cmd, state.Buffers.PositionTerms);
            foreach (ParticleForce force in StandardForces.All) force.SetDensity(cmd, kernel, state);
            if (state.HasBodies) kernel.SetOut(cmd, state.Walls.Contacts);
            kernel.Set(cmd, state.Published.Counters);
        }
    }
}
