using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Normals of the liquid's surface at each particle.</summary>
    internal sealed class SurfaceNormalsPass : ComputePass
    {
        private static readonly int NormalFactor = Id("_NormalFactor");
        private static readonly int WallNormal = Id("_WallNormal");

        private readonly ComputeKernel kernel;

        public SurfaceNormalsPass(FluidShaderSet shaders)
            : base(shaders, "SurfaceNormals")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, StandardState state)
        {
            FluidSolverSettings settings = state.Settings;
            double radius = settings.SupportRadius;
            using (Sample(cmd))
            {
                PairBindings.Set(cmd, kernel, state);
                kernel.SetFloat(cmd, NormalFactor,
                    (float)(radius * settings.ParticleMass * WendlandKernel.SlopeFactor(radius) / settings.RestDensity));
                kernel.SetFloat(cmd, WallNormal, (float)(0.5 * radius * CapillaryRules.WallShare(state.Own.ContactAngle)));
                kernel.SetOut(cmd, state.ForceBuffers<TensionBuffers>().SurfaceNormals);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
