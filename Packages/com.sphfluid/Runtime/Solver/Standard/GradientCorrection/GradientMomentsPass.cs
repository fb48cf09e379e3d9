using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Moments of each particle's neighbours at a sort.</summary>
    internal sealed class GradientMomentsPass : ComputePass
    {
        private static readonly int MomentFactor = Id("_MomentFactor");
        private static readonly int LatticeMoment = Id("_LatticeMoment");
        private static readonly int RestDensity = Id("_RestDensity");

        private readonly ComputeKernel kernel;

        public GradientMomentsPass(FluidShaderSet shaders)
            : base(shaders, "GradientMoments")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, StandardState state)
        {
            using (Sample(cmd))
            {
                PairBindings.Set(cmd, kernel, state);
                FluidSolverSettings settings = state.Settings;
                kernel.SetFloat(cmd, MomentFactor, (float)(settings.ParticleMass * WendlandKernel.SlopeFactor(settings.SupportRadius)));
                kernel.SetFloat(cmd, LatticeMoment, (float)WendlandKernel.LatticeMoment(settings.SupportRadius / settings.Spacing));
                kernel.SetFloat(cmd, RestDensity, settings.RestDensity);
                kernel.Set(cmd, state.List.Densities);
                kernel.SetOut(cmd, state.ForceBuffers<GradientCorrectionBuffers>().Moments);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
