using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>How far the density of each particle is from what it may be, and what that changes of its multiplier.</summary>
    internal sealed class ConstrainDensityPass : ComputePass
    {
        private static readonly int DensityFactor = Id("_DensityFactor");
        private static readonly int InverseMoment = Id("_InverseMoment");
        private static readonly int Relaxation = Id("_Relaxation");
        private static readonly int Compliance = Id("_Compliance");
        private static readonly int SupportSquared = Id("_SupportSquared");
        private static readonly int Ahead = Id("_Ahead");
        private static readonly int Places = Id("_Places");
        private static readonly int HasPressures = Id("_HasPressures");

        private readonly ComputeKernel search, listed, measure;

        public ConstrainDensityPass(FluidShaderSet shaders)
            : base(shaders, "ConstrainDensity")
        {
            search = Kernel();
            listed = Kernel("ConstrainListed");
            measure = Kernel("MeasureDensity");
        }

        /// <summary>The first iteration of a step: finds the neighbours at the predicted places, and lists them.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="state">Buffers.</param>
        /// <param name="compliance">α [1/m²].</param>
        public void Record(CommandBuffer cmd, RobustState state, double compliance)
        {
            using (Sample(cmd))
            {
                BindSearch(cmd, search, state);
                BindConstraint(cmd, search, state, compliance);
                search.DispatchThreads(cmd, state.ParticleCount);
            }
        }

        /// <summary>A later iteration, or the first of a step whose neighbours are listed.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="state">Buffers.</param>
        /// <param name="compliance">α [1/m²].</param>
        /// <param name="places">Where the particles are [m]; w: λ [m²].</param>
        public void RecordListed(CommandBuffer cmd, RobustState state, double compliance, FluidBuffer places)
        {
            using (Sample(cmd))
            {
                Bind(cmd, listed, state);
                BindConstraint(cmd, listed, state, compliance);
                listed.SetBuffer(cmd, Places, places);
                listed.DispatchThreads(cmd, state.ParticleCount);
            }
        }

        /// <summary>Density and pressure for readers, and lists of the neighbours, in the order of a sort at the present places.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="state">Buffers.</param>
        /// <param name="hasPressures">Whether a step has left pressures.</param>
        public void RecordMeasured(CommandBuffer cmd, RobustState state, bool hasPressures)
        {
            using (Sample(cmd))
            {
                BindSearch(cmd, measure, state);
                measure.SetBool(cmd, HasPressures, hasPressures);
                measure.Set(cmd, state.Motion.Starts);
                measure.Set(cmd, state.Published.Counters);
                measure.DispatchThreads(cmd, state.ParticleCount);
            }
        }

        private static void BindSearch(CommandBuffer cmd, ComputeKernel kernel, RobustState state)
        {
            Bind(cmd, kernel, state);
            kernel.SetFloat(cmd, Ahead, state.ListTime);
            kernel.Set(cmd, state.Buffers.Velocities);
        }

        private static void BindConstraint(CommandBuffer cmd, ComputeKernel kernel, RobustState state, double compliance)
        {
            RobustBindings.SetGradients(cmd, kernel, state.Settings);
            kernel.SetFloat(cmd, Relaxation, state.Own.Relaxation);
            kernel.SetFloat(cmd, Compliance, (float)compliance);
        }

        private static void Bind(CommandBuffer cmd, ComputeKernel kernel, RobustState state)
        {
            FluidSolverSettings settings = state.Settings;
            CellBindings.SetSearch(cmd, kernel, state);
            CellBindings.SetWalls(cmd, kernel, state);
            state.List.SetOut(cmd, kernel);
            kernel.SetFloat(cmd, SupportSquared, settings.SupportRadius * settings.SupportRadius);
            kernel.SetFloat(cmd, DensityFactor, (float)(settings.ParticleMass * WendlandKernel.Factor(settings.SupportRadius)));
            kernel.SetFloat(cmd, InverseMoment, (float)(1.0 / WendlandKernel.LatticeMoment(settings.SupportRadius / settings.Spacing)));
            kernel.Set(cmd, state.Buffers.Positions);
            kernel.SetOut(cmd, state.Buffers.PositionTerms);
            if (state.HasBodies) kernel.SetOut(cmd, state.Walls.Contacts);
        }
    }
}
