using Unity.Profiling;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Particles in the order of their cells (Shaders/Solver/Standard/ScatterParticles.compute): one dispatch, or two for an order without chance.</summary>
    internal sealed class ScatterParticlesPass
    {
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker("ScatterParticles");

        readonly ComputeKernel scatter;
        readonly ComputeKernel scatterOrder;
        readonly ComputeKernel reorder;

        public ScatterParticlesPass(FluidShaderSet shaders)
        {
            scatter = shaders.Kernel("ScatterParticles", "Scatter");
            scatterOrder = shaders.Kernel("ScatterParticles", "ScatterOrder");
            reorder = shaders.Kernel("ScatterParticles", "Reorder");
        }

        public void Record(CommandBuffer cmd, FluidState state)
        {
            cmd.BeginSample(Marker);
            if (state.Settings.StableOrder)
            {
                Bind(cmd, scatterOrder, state);
                scatterOrder.SetBuffer(cmd, StandardShaderIds.Rank, state.Standard.Rank);
                scatterOrder.SetBuffer(cmd, StandardShaderIds.OrderOut, state.Standard.Order);
                scatterOrder.DispatchThreads(cmd, state.ParticleCount);
                Bind(cmd, reorder, state);
                reorder.SetBuffer(cmd, StandardShaderIds.Order, state.Standard.Order);
                Target(cmd, reorder, state);
                reorder.DispatchThreads(cmd, state.ParticleCount);
            }
            else
            {
                Bind(cmd, scatter, state);
                scatter.SetBuffer(cmd, StandardShaderIds.Rank, state.Standard.Rank);
                Target(cmd, scatter, state);
                scatter.DispatchThreads(cmd, state.ParticleCount);
            }
            cmd.EndSample(Marker);
        }

        static void Bind(CommandBuffer cmd, ComputeKernel kernel, FluidState state)
        {
            CellRowsBinding.Set(cmd, kernel, state.Cells, state.Standard.CellStart);
            kernel.SetInt(cmd, FluidShaderIds.ParticleCount, state.ParticleCount);
            kernel.SetBuffer(cmd, StandardShaderIds.NewPositions, state.Standard.NewPositions);
            kernel.SetBuffer(cmd, StandardShaderIds.NewVelocities, state.Standard.NewVelocities);
        }

        static void Target(CommandBuffer cmd, ComputeKernel kernel, FluidState state)
        {
            kernel.SetBuffer(cmd, StandardShaderIds.PositionsOut, state.Standard.Positions);
            kernel.SetBuffer(cmd, StandardShaderIds.VelocitiesOut, state.Standard.Velocities);
        }
    }
}
