using Unity.Profiling;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Thesis 6.4.2: empties the marching-cubes grid before the density factors are summed.</summary>
    sealed class ResetMCGridPass
    {
        const string Name = "ResetMCGrid";
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker(Name);

        readonly ComputeKernel kernel;

        public ResetMCGridPass(FluidShaderSet shaders)
        {
            kernel = new ComputeKernel(shaders.SurfaceField, Name);
        }

        public void Record(CommandBuffer cmd, SurfaceField field)
        {
            int side = field.Grid.VerticesPerSide;
            cmd.BeginSample(Marker);
            kernel.SetBuffer(cmd, SurfaceShaderIds.MCGrid, field.Values);
            kernel.SetVector(cmd, SurfaceShaderIds.MCGridMinimum, field.Grid.MinimumAndCells);
            kernel.DispatchThreads(cmd, side, side, side);
            cmd.EndSample(Marker);
        }
    }
}
