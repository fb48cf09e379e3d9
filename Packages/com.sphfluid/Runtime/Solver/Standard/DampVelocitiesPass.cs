using Unity.Profiling;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Slows all particles behind a step, for liquids that are to come to rest (Shaders/Solver/Standard/DampVelocities.compute).</summary>
    internal sealed class DampVelocitiesPass
    {
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker("DampVelocities");

        readonly ComputeKernel kernel;

        public DampVelocitiesPass(FluidShaderSet shaders)
        {
            kernel = shaders.Kernel("DampVelocities", "DampVelocities");
        }

        /// <param name="cmd">Command buffer to record into, behind a step.</param>
        /// <param name="state">Buffers.</param>
        /// <param name="damping">Part of each velocity that is left, 0 to 1.</param>
        public void Record(CommandBuffer cmd, FluidState state, float damping)
        {
            cmd.BeginSample(Marker);
            kernel.SetInt(cmd, FluidShaderIds.ParticleCount, state.ParticleCount);
            kernel.SetFloat(cmd, StandardShaderIds.Damping, damping);
            kernel.SetBuffer(cmd, StandardShaderIds.NewVelocitiesOut, state.Standard.NewVelocities);
            kernel.DispatchThreads(cmd, state.ParticleCount);
            cmd.EndSample(Marker);
        }
    }
}
