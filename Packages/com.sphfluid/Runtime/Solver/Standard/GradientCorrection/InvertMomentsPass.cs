using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>The correction of each particle's pressure until the next sort, from the moments about it.</summary>
    internal sealed class InvertMomentsPass : ComputePass
    {
        private static readonly int InverseMoment = Id("_InverseMoment");

        private readonly ComputeKernel kernel;

        public InvertMomentsPass(FluidShaderSet shaders)
            : base(shaders, "InvertMoments")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, StandardState state)
        {
            FluidSolverSettings settings = state.Settings;
            var buffers = state.ForceBuffers<GradientCorrectionBuffers>();
            using (Sample(cmd))
            {
                PairBindings.Set(cmd, kernel, state);
                kernel.SetFloat(cmd, InverseMoment, (float)(1.0 / WendlandKernel.LatticeMoment(settings.SupportRadius / settings.Spacing)));
                kernel.Set(cmd, buffers.Moments);
                kernel.SetOut(cmd, buffers.Corrections);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
