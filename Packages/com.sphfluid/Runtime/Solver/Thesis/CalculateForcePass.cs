using Unity.Profiling;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Thesis 6.3.2: force densities of pressure, equations (13) and (14), and of viscosity, (15) to (17).</summary>
    internal sealed class CalculateForcePass
    {
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker("CalculateForce");

        readonly ComputeKernel kernel;

        public CalculateForcePass(FluidShaderSet shaders)
        {
            kernel = shaders.Kernel("CalculateForce", "CalculateForce");
        }

        public void Record(CommandBuffer cmd, FluidState state)
        {
            FluidSolverSettings settings = state.Settings;
            double factor = settings.ParticleMass * ThesisKernels.SpikyGradientFactor(settings.SupportRadius);
            cmd.BeginSample(Marker);
            GridNeighbours.SetNeighbours(cmd, kernel, state);
            kernel.SetInt(cmd, FluidShaderIds.ParticleCount, state.ParticleCount);
            kernel.SetFloat(cmd, FluidShaderIds.SmoothLength, settings.SupportRadius);
            kernel.SetFloat(cmd, FluidShaderIds.PressureCoefficient, (float)(settings.PressureHalf ? 0.5 * factor : factor));
            kernel.SetFloat(cmd, FluidShaderIds.ViscosityCoefficient, (float)(settings.Viscosity * factor));
            kernel.SetBuffer(cmd, FluidShaderIds.Density, state.Buffers.Density);
            kernel.SetBuffer(cmd, FluidShaderIds.Pressure, state.Buffers.Pressure);
            kernel.SetBuffer(cmd, FluidShaderIds.Force, state.Thesis.Force);
            kernel.DispatchThreads(cmd, state.ParticleCount);
            cmd.EndSample(Marker);
        }
    }
}
