using Unity.Profiling;
using UnityEngine;
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
            kernel = shaders.Kernel("SurfaceField", Name);
        }

        public void Record(CommandBuffer cmd, SurfaceField field)
        {
            Vector3Int vertices = field.Grid.Vertices;
            cmd.BeginSample(Marker);
            kernel.SetBuffer(cmd, SurfaceShaderIds.MCGrid, field.Values);
            kernel.SetGrid(cmd, field.Grid);
            kernel.DispatchThreads(cmd, vertices.x, vertices.y, vertices.z);
            cmd.EndSample(Marker);
        }
    }
}
