using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Thesis 6.3.1: density by poly6, equations (11) and (12), and pressure, equation (10).</summary>
    internal sealed class CalculateDensityPass : ComputePass
    {
        // Below every pressure: equation (10) as printed.
        private const float NoFloor = -1e30f;

        private static readonly int ParticleCount = Id("_ParticleCount");
        private static readonly int SelfDensity = Id("_SelfDensity");
        private static readonly int RestDensity = Id("_RestDensity");
        private static readonly int Stiffness = Id("_Stiffness");
        private static readonly int PressureFloor = Id("_PressureFloor");

        private readonly ComputeKernel kernel;

        public CalculateDensityPass(FluidShaderSet shaders)
            : base(shaders, "CalculateDensity")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, ThesisState state)
        {
            FluidSolverSettings settings = state.Settings;
            ThesisSettings own = state.Own;
            using (Sample(cmd))
            {
                GridNeighbours.Set(cmd, kernel, state);
                kernel.SetInt(cmd, ParticleCount, state.ParticleCount);
                kernel.SetBool(cmd, SelfDensity, own.SelfDensity);
                kernel.SetFloat(cmd, RestDensity, settings.RestDensity);
                kernel.SetFloat(cmd, Stiffness, own.Stiffness);
                kernel.SetFloat(cmd, PressureFloor, settings.PressureClamp ? 0f : NoFloor);
                kernel.Set(cmd, state.Published.Density);
                kernel.Set(cmd, state.Published.Pressure);
                kernel.Set(cmd, state.Published.Counters);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
