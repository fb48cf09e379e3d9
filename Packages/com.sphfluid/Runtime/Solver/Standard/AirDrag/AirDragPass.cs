using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Drag of air: velocities with which a step begins, slowed by how much of a particle's neighbourhood is empty.</summary>
    internal sealed class AirDragPass : ComputePass
    {
        private static readonly int ParticleCount = Id("_ParticleCount");
        private static readonly int RestDensity = Id("_RestDensity");
        private static readonly int Exposure = Id("_Exposure");
        private static readonly int Drag = Id("_Drag");

        private readonly ComputeKernel kernel;

        public AirDragPass(FluidShaderSet shaders)
            : base(shaders, "AirDrag")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, StandardState state, in FluidStep step)
        {
            FluidSolverSettings settings = state.Settings;
            double radius = settings.SupportRadius, moment = WendlandKernel.LatticeMoment(radius / settings.Spacing);
            using (Sample(cmd))
            {
                kernel.SetInt(cmd, ParticleCount, state.ParticleCount);
                kernel.SetFloat(cmd, RestDensity, settings.RestDensity);
                kernel.SetFloat(cmd, Exposure,
                    (float)(moment / (settings.RestDensity - settings.ParticleMass * WendlandKernel.Factor(radius))));
                kernel.SetFloat(cmd, Drag, (float)(AirDragForce.Rate(settings) * MotionBindings.KickOf(step)));
                kernel.Set(cmd, state.Buffers.Densities);
                kernel.SetOut(cmd, state.Buffers.Velocities);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
