using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// A Unity mesh that the GPU fills with a sparse surface: float3 positions and float3 normals in one stream, 32-bit
    /// indices. It has no copy on the CPU.
    /// </summary>
    internal sealed class FilledMesh : IDisposable
    {
        private const int VertexStride = 6 * sizeof(float);

        // Unity has nothing to check: the content is on the GPU.
        private const MeshUpdateFlags Unchecked = MeshUpdateFlags.DontRecalculateBounds | MeshUpdateFlags.DontValidateIndices |
            MeshUpdateFlags.DontResetBoneBounds;

        private readonly WriteSurfaceMeshPass writeMesh;
        private Mesh mesh;

        /// <exception cref="FluidDeviceException">The kernel is missing, or the device cannot run it.</exception>
        public FilledMesh(FluidShaderSet shaders, string name)
        {
            writeMesh = new WriteSurfaceMeshPass(shaders);
            mesh = new Mesh { name = name, hideFlags = HideFlags.HideAndDontSave };
            mesh.vertexBufferTarget |= GraphicsBuffer.Target.Raw;
            mesh.indexBufferTarget |= GraphicsBuffer.Target.Raw;
        }

        public Mesh Mesh => mesh;

        /// <summary>Vertices that fit.</summary>
        public int VertexCapacity { get; private set; }

        /// <summary>Indices that fit.</summary>
        public int IndexCapacity { get; private set; }

        /// <summary>Bytes of GPU memory.</summary>
        public long GpuBytes => (long)VertexCapacity * VertexStride + (long)IndexCapacity * sizeof(uint);

        /// <summary>Fills the mesh from a surface, at once; grows with the surface's buffers.</summary>
        /// <param name="cmd">Command buffer to use; cleared.</param>
        /// <param name="surface">The surface, simulation space.</param>
        /// <param name="toMesh">Simulation space to the mesh's; with an inverse.</param>
        /// <param name="domainSize">Edges of the domain, which holds the surface [m].</param>
        /// <exception cref="FluidDeviceException">The device cannot hold the mesh.</exception>
        public void Fill(CommandBuffer cmd, in SurfaceBuffers surface, in Matrix4x4 toMesh, Vector3 domainSize)
        {
            Reserve(surface.Vertices.count, surface.Indices.count);
            mesh.bounds = AffineMath.BoundsOf(toMesh, domainSize);
            using (GraphicsBuffer vertices = mesh.GetVertexBuffer(0))
            using (GraphicsBuffer indices = mesh.GetIndexBuffer())
            {
                cmd.Clear();
                writeMesh.Record(cmd, surface, vertices, indices, toMesh);
                Graphics.ExecuteCommandBuffer(cmd);
            }
        }

        public void Dispose()
        {
            OwnedObject.Destroy(ref mesh);
            VertexCapacity = 0;
            IndexCapacity = 0;
        }

        private void Reserve(int vertices, int indices)
        {
            if (vertices <= VertexCapacity && indices <= IndexCapacity) return;
            long bytes = Math.Max((long)vertices * VertexStride, (long)indices * sizeof(uint));
            if (bytes > SystemInfo.maxGraphicsBufferSize)
            {
                throw new FluidDeviceException(
                    $"The mesh of the surface needs a buffer of {bytes / 1048576.0:F0} MiB; " +
                    $"{SystemInfo.graphicsDeviceName} allows {SystemInfo.maxGraphicsBufferSize / 1048576.0:F0} MiB. " +
                    "Use a coarser surface or a smaller triangle budget.");
            }
            VertexCapacity = Math.Max(vertices, VertexCapacity);
            IndexCapacity = Math.Max(indices, IndexCapacity);
            mesh.Clear();
            mesh.SetVertexBufferParams(
                VertexCapacity, new VertexAttributeDescriptor(VertexAttribute.Position),
                new VertexAttributeDescriptor(VertexAttribute.Normal));
            mesh.SetIndexBufferParams(IndexCapacity, IndexFormat.UInt32);
            mesh.SetSubMesh(0, new SubMeshDescriptor(0, IndexCapacity) { vertexCount = VertexCapacity }, Unchecked);
        }
    }
}
