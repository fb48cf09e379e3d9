using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Copies a sparse surface into the vertex and index buffers of a mesh; what the surface does not use becomes
    /// triangles without area (Shaders/Surface/Sparse/WriteSurfaceMesh.compute).
    /// </summary>
    internal sealed class WriteSurfaceMeshPass : ComputePass
    {
        private static readonly int SurfaceIndices = Id("_SurfaceIndices");
        private static readonly int SurfaceDrawArguments = Id("_SurfaceDrawArguments");
        private static readonly int MeshVertices = Id("_MeshVertices");
        private static readonly int MeshIndices = Id("_MeshIndices");
        private static readonly int SurfaceToMesh = Id("_SurfaceToMesh");
        private static readonly int NormalToMesh = Id("_NormalToMesh");
        private static readonly int MeshVertexCount = Id("_MeshVertexCount");
        private static readonly int MeshTriangleCount = Id("_MeshTriangleCount");
        private static readonly int MeshMirrored = Id("_MeshMirrored");

        private readonly ComputeKernel kernel;

        /// <exception cref="FluidDeviceException">The kernel is missing, or the device cannot run it.</exception>
        public WriteSurfaceMeshPass(FluidShaderSet shaders)
            : base(shaders, "WriteSurfaceMesh")
        {
            kernel = Kernel();
        }

        /// <summary>Records the copy.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="surface">The surface, simulation space.</param>
        /// <param name="vertices">Raw: float3 position and float3 normal each.</param>
        /// <param name="indices">Raw: 32-bit indices; as many as the surface can have, or more.</param>
        /// <param name="toMesh">Simulation space to the mesh's; with an inverse.</param>
        public void Record(CommandBuffer cmd, in SurfaceBuffers surface, GraphicsBuffer vertices,
            GraphicsBuffer indices, in Matrix4x4 toMesh)
        {
            int triangles = indices.count / 3;
            using (Sample(cmd))
            {
                kernel.SetBuffer(cmd, SurfaceBuffers.VerticesId, surface.Vertices);
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
            }
        }
    }
}
