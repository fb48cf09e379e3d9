using Unity.Profiling;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Thesis 6.3.4: leapfrog, equations (19) to (21).</summary>
    internal sealed class CalculateNewPositionPass
    {
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker("CalculateNewPosition");

        readonly ComputeKernel kernel;

        public CalculateNewPositionPass(FluidShaderSet shaders)
        {
            kernel = shaders.Kernel("CalculateNewPosition", "CalculateNewPosition");
        }

        public void Record(CommandBuffer cmd, FluidState state, in FluidStep step)
        {
            FluidSolverSettings settings = state.Settings;
            cmd.BeginSample(Marker);
            DomainBindings.SetPeriodic(cmd, kernel, settings);
            kernel.SetInt(cmd, FluidShaderIds.ParticleCount, state.ParticleCount);
            kernel.SetFloat(cmd, FluidShaderIds.TimeStep, step.Length);
            kernel.SetFloat(cmd, FluidShaderIds.KickStep, step.Kick);
            kernel.SetFloat(cmd, FluidShaderIds.KickPart, step.KickPart);
            kernel.SetBool(cmd, FluidShaderIds.FirstStep, step.IsFirst && settings.HalfKick);
            kernel.SetVector(cmd, FluidShaderIds.DomainHalfSize, 0.5f * settings.DomainSize);
            kernel.SetBuffer(cmd, FluidShaderIds.Particles, state.Buffers.Particles);
            kernel.SetBuffer(cmd, FluidShaderIds.Acceleration, state.Thesis.Acceleration);
            kernel.SetBuffer(cmd, FluidShaderIds.Counters, state.Buffers.Counters);
            kernel.DispatchThreads(cmd, state.ParticleCount);
            cmd.EndSample(Marker);
        }
    }
}
