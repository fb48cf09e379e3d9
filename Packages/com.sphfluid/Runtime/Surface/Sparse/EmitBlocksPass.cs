using Unity.Profiling;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Vertices and triangles of all blocks, a group each (Shaders/Surface/Sparse/EmitBlocks.compute).</summary>
    sealed class EmitBlocksPass
    {
        const string Name = "EmitBlocks";
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker(Name);

        readonly ComputeKernel kernel;

        public EmitBlocksPass(FluidShaderSet shaders)
        {
            kernel = shaders.Kernel("EmitBlocks", Name);
        }

        public void Record(CommandBuffer cmd, in BlockPolygons input, BlockMesh mesh)
        {
            cmd.BeginSample(Marker);
            input.SetGlobals(cmd, kernel);
            kernel.SetBuffer(cmd, SurfaceShaderIds.SurfaceVertices, mesh.Vertices);
            kernel.SetBuffer(cmd, SurfaceShaderIds.SurfaceIndices, mesh.Indices);
            kernel.DispatchIndirect(cmd, mesh.EmitArguments);
            cmd.EndSample(Marker);
        }
    }
}
