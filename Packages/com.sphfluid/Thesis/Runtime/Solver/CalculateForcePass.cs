using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Thesis 6.3.2: force densities of pressure, equations (13) and (14), and of viscosity, (15) to (17).</summary>
    internal sealed class CalculateForcePass : ComputePass
    {
        private static readonly int ParticleCount = Id("_ParticleCount");
        private static readonly int SmoothLength = Id("_SmoothLength");
        private static readonly int PressureCoefficient = Id("_PressureCoefficient");
        private static readonly int ViscosityCoefficient = Id("_ViscosityCoefficient");

        private readonly ComputeKernel kernel;

        public CalculateForcePass(FluidShaderSet shaders)
            : base(shaders, "CalculateForce")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, ThesisState state)
        {
            FluidSolverSettings settings = state.Settings;
            ThesisSettings own = state.Own;
            double factor = settings.ParticleMass * MullerKernels.SpikyGradientFactor(settings.SupportRadius);
            using (Sample(cmd))
            {
                GridNeighbours.Set(cmd, kernel, state);
                kernel.SetInt(cmd, ParticleCount, state.ParticleCount);
                kernel.SetFloat(cmd, SmoothLength, settings.SupportRadius);
                kernel.SetFloat(cmd, PressureCoefficient, (float)(own.PressureHalf ? 0.5 * factor : factor));
                kernel.SetFloat(cmd, ViscosityCoefficient, (float)(settings.Viscosity * factor));
                kernel.Set(cmd, state.Published.Density);
                kernel.Set(cmd, state.Published.Pressure);
                kernel.Set(cmd, state.Buffers.Force);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
