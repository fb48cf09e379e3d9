using Unity.Profiling;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Thesis 6.2.4: every cell is empty.</summary>
    internal sealed class ResetGridIndicesPass
    {
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker("ResetGridIndices");

        readonly ComputeKernel kernel;

        public ResetGridIndicesPass(FluidShaderSet shaders)
        {
            kernel = shaders.Kernel("ResetGridIndices", "ResetGridIndices");
        }

        public void Record(CommandBuffer cmd, FluidState state)
        {
            cmd.BeginSample(Marker);
            kernel.SetInt(cmd, FluidShaderIds.CellCount, state.Grid.CellCount);
            kernel.SetBuffer(cmd, FluidShaderIds.GridIndices, state.Buffers.GridIndices);
            kernel.DispatchThreads(cmd, state.Grid.CellCount);
            cmd.EndSample(Marker);
        }
    }
}
