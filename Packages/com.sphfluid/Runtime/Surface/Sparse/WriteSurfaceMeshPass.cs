using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Copies a sparse surface into the vertex and index buffers of a mesh; what the surface does not use becomes triangles without area.</summary>
    sealed class WriteSurfaceMeshPass
    {
        const string Name = "WriteSurfaceMesh";
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker(Name);

        static readonly int SurfaceIndices = Shader.PropertyToID("_SurfaceIndices");
        static readonly int SurfaceDrawArguments = Shader.PropertyToID("_SurfaceDrawArguments");
        static readonly int MeshVertices = Shader.PropertyToID("_MeshVertices");
        static readonly int MeshIndices = Shader.PropertyToID("_MeshIndices");
        static readonly int SurfaceToMesh = Shader.PropertyToID("_SurfaceToMesh");
        static readonly int NormalToMesh = Shader.PropertyToID("_NormalToMesh");
        static readonly int MeshVertexCount = Shader.PropertyToID("_MeshVertexCount");
        static readonly int MeshTriangleCount = Shader.PropertyToID("_MeshTriangleCount");
        static readonly int MeshMirrored = Shader.PropertyToID("_MeshMirrored");

        readonly ComputeKernel kernel;

        /// <exception cref="FluidDeviceException">The kernel is missing, or the device cannot run it.</exception>
        public WriteSurfaceMeshPass(FluidShaderSet shaders)
        {
            kernel = shaders.Kernel("WriteSurfaceMesh", Name);
        }

        /// <summary>Records the copy.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="surface">The surface, simulation space.</param>
        /// <param name="vertices">Raw: float3 position and float3 normal each.</param>
        /// <param name="indices">Raw: 32-bit indices; room for all that the surface can have.</param>
        /// <param name="toMesh">Simulation space to the mesh's; with an inverse.</param>
        public void Record(CommandBuffer cmd, in SurfaceBuffers surface, GraphicsBuffer vertices, GraphicsBuffer indices, in Matrix4x4 toMesh)
        {
            int triangles = indices.count / 3;
            cmd.BeginSample(Marker);
            kernel.SetBuffer(cmd, SurfaceShaderIds.SurfaceVertices, surface.Vertices);
            kernel.SetBuffer(cmd, SurfaceIndices, surface.Indices);
            kernel.SetBuffer(cmd, SurfaceDrawArguments, surface.Arguments);
            kernel.SetBuffer(cmd, MeshVertices, vertices);
            kernel.SetBuffer(cmd, MeshIndices, indices);
            kernel.SetMatrix(cmd, SurfaceToMesh, toMesh);
            kernel.SetMatrix(cmd, NormalToMesh, toMesh.inverse.transpose);
            kernel.SetInt(cmd, MeshVertexCount, Mathf.Min(vertices.count, surface.Vertices.count));
            kernel.SetInt(cmd, MeshTriangleCount, triangles);
            kernel.SetBool(cmd, MeshMirrored, toMesh.determinant < 0f);
            kernel.DispatchThreads(cmd, Mathf.Max(vertices.count, triangles));
            cmd.EndSample(Marker);
        }
    }
}
