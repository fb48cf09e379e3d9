using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Decides on the GPU whether the surface fits the buffers, and so how much is emitted and drawn; what does not fit leaves the last complete
    /// surface alone (Shaders/Surface/Sparse/SurfaceDrawArguments.compute).
    /// </summary>
    sealed class SurfaceDrawArgumentsPass
    {
        const string Name = "SurfaceDrawArguments";
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker(Name);
        static readonly int DrawArguments = Shader.PropertyToID("_DrawArguments");
        static readonly int EmitArguments = Shader.PropertyToID("_EmitArguments");
        static readonly int VertexCapacity = Shader.PropertyToID("_VertexCapacity");
        static readonly int IndexCapacity = Shader.PropertyToID("_IndexCapacity");

        readonly ComputeKernel kernel;

        public SurfaceDrawArgumentsPass(FluidShaderSet shaders)
        {
            kernel = shaders.Kernel("SurfaceDrawArguments", Name);
        }

        public void Record(CommandBuffer cmd, SurfaceBlocks blocks, BlockMesh mesh)
        {
            cmd.BeginSample(Marker);
            blocks.SetGlobals(cmd, kernel);
            kernel.SetInt(cmd, VertexCapacity, mesh.VertexCapacity);
            kernel.SetInt(cmd, IndexCapacity, mesh.IndexCapacity);
            kernel.SetBuffer(cmd, SparseShaderIds.SurfaceCounters, blocks.Counters);
            kernel.SetBuffer(cmd, DrawArguments, mesh.DrawArguments);
            kernel.SetBuffer(cmd, EmitArguments, mesh.EmitArguments);
            kernel.DispatchThreads(cmd, 1);
            cmd.EndSample(Marker);
        }
    }
}
