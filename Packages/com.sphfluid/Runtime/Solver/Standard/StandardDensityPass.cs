using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Density by summation with the walls' share, and the pressure term.</summary>
    internal sealed class StandardDensityPass : ComputePass
    {
        static readonly int DensityFactor = Id("_DensityFactor");
        static readonly int InverseMoment = Id("_InverseMoment");
        static readonly int SoundSpeedSquared = Id("_SoundSpeedSquared");
        static readonly int SuctionFloor = Id("_SuctionFloor");

        readonly ComputeKernel kernel;

        public StandardDensityPass(FluidShaderSet shaders)
            : base(shaders, "StandardDensity")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, StandardState state)
        {
            FluidSolverSettings settings = state.Settings;
            using (Sample(cmd))
            {
                StandardBindings.SetSearch(cmd, kernel, state);
                StandardBindings.SetWalls(cmd, kernel, state);
                state.List.SetOut(cmd, kernel);
                kernel.SetFloat(cmd, DensityFactor, (float)(settings.ParticleMass * WendlandKernel.Factor(settings.SupportRadius)));
                kernel.SetFloat(cmd, InverseMoment, (float)(1.0 / WendlandKernel.LatticeMoment(settings.SupportRadius / settings.Spacing)));
                kernel.SetFloat(cmd, SoundSpeedSquared, settings.SoundSpeed * settings.SoundSpeed);
                kernel.SetFloat(cmd, SuctionFloor, settings.PressureClamp ? 0f : -settings.RestDensity);
                kernel.Set(cmd, state.Buffers.Positions);
                kernel.SetOut(cmd, state.Buffers.DensityTerms);
                kernel.Set(cmd, state.Published.Counters);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
