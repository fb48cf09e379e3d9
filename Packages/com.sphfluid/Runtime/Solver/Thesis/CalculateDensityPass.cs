using Unity.Profiling;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Thesis 6.3.1: density by poly6, equations (11) and (12), and pressure, equation (10).</summary>
    internal sealed class CalculateDensityPass
    {
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker("CalculateDensity");

        // Below every pressure: equation (10) as printed.
        const float NoFloor = -1e30f;

        readonly ComputeKernel kernel;

        public CalculateDensityPass(FluidShaderSet shaders)
        {
            kernel = shaders.Kernel("CalculateDensity", "CalculateDensity");
        }

        public void Record(CommandBuffer cmd, FluidState state)
        {
            FluidSolverSettings settings = state.Settings;
            cmd.BeginSample(Marker);
            GridNeighbours.SetNeighbours(cmd, kernel, state);
            kernel.SetInt(cmd, FluidShaderIds.ParticleCount, state.ParticleCount);
            kernel.SetBool(cmd, FluidShaderIds.SelfDensity, settings.SelfDensity);
            kernel.SetFloat(cmd, FluidShaderIds.RestDensity, settings.RestDensity);
            kernel.SetFloat(cmd, FluidShaderIds.Stiffness, settings.Stiffness);
            kernel.SetFloat(cmd, FluidShaderIds.PressureFloor, settings.PressureClamp ? 0f : NoFloor);
            kernel.SetBuffer(cmd, FluidShaderIds.Density, state.Buffers.Density);
            kernel.SetBuffer(cmd, FluidShaderIds.Pressure, state.Buffers.Pressure);
            kernel.SetBuffer(cmd, FluidShaderIds.Counters, state.Buffers.Counters);
            kernel.DispatchThreads(cmd, state.ParticleCount);
            cmd.EndSample(Marker);
        }
    }
}
