using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Surface tension: velocities with which a step begins, changed by what depends on positions alone.</summary>
    internal sealed class SurfaceTensionPass : ComputePass
    {
        private static readonly int PairPull = Id("_PairPull");
        private static readonly int NormalPull = Id("_NormalPull");
        private static readonly int WallPull = Id("_WallPull");
        private static readonly int KickStep = Id("_KickStep");

        private readonly ComputeKernel kernel;

        public SurfaceTensionPass(FluidShaderSet shaders)
            : base(shaders, "SurfaceTension")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, StandardState state, in FluidStep step)
        {
            FluidSolverSettings settings = state.Settings;
            StandardSettings own = state.Own;
            double density = settings.RestDensity, radius = settings.SupportRadius;
            double cohesion = CapillaryRules.Cohesion(own.SurfaceTension, settings.Spacing, radius / settings.Spacing);
            using (Sample(cmd))
            {
                PairBindings.Set(cmd, kernel, state);
                kernel.SetFloat(cmd, PairPull,
                    (float)(2.0 * cohesion * settings.ParticleMass * WendlandKernel.SlopeFactor(radius) / (density * density)));
                kernel.SetFloat(cmd, NormalPull, (float)CapillaryRules.NormalPull(own.SurfaceTension, settings));
                kernel.SetFloat(cmd, WallPull, (float)(CapillaryRules.WallShare(own.ContactAngle) * cohesion / density));
                kernel.SetFloat(cmd, KickStep, MotionBindings.KickOf(step));
                kernel.Set(cmd, state.ForceBuffers<TensionBuffers>().SurfaceNormals);
                kernel.SetOut(cmd, state.Buffers.Velocities);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
