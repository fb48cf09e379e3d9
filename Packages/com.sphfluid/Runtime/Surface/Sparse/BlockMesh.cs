using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The triangles of a sparse surface on the GPU: vertices, indices and the arguments of an indexed indirect draw.</summary>
    sealed class BlockMesh : IDisposable
    {
        const int DrawArgumentCount = 5;
        const int DispatchArgumentCount = 3;

        static readonly uint[] NothingDrawn = new uint[DrawArgumentCount];

        GraphicsBuffer vertices;
        GraphicsBuffer indices;
        GraphicsBuffer drawArguments;
        GraphicsBuffer emitArguments;

        public BlockMesh()
        {
            drawArguments = GpuBuffers.CreateArguments("SurfaceDrawArguments", DrawArgumentCount);
            emitArguments = GpuBuffers.CreateArguments("SurfaceEmitArguments", DispatchArgumentCount);
            Reserve(1, 1);
        }

        /// <summary>Most vertices that a buffer of this device holds.</summary>
        public static int DeviceVertexLimit => (int)Math.Min(SystemInfo.maxGraphicsBufferSize / PackedSurfaceVertex.Stride, int.MaxValue);

        /// <summary>Most indices that a buffer of this device holds.</summary>
        public static int DeviceIndexLimit => (int)Math.Min(SystemInfo.maxGraphicsBufferSize / sizeof(uint), int.MaxValue);

        /// <summary><see cref="PackedSurfaceVertex"/> each; equal ones only where blocks meet.</summary>
        public GraphicsBuffer Vertices => vertices;

        /// <summary>uint each, three a triangle.</summary>
        public GraphicsBuffer Indices => indices;

        /// <summary>One <see cref="GraphicsBuffer.IndirectDrawIndexedArgs"/>.</summary>
        public GraphicsBuffer DrawArguments => drawArguments;

        /// <summary>Groups along x, y and z of a dispatch with a group a block.</summary>
        public GraphicsBuffer EmitArguments => emitArguments;

        /// <summary>Vertices that may be written.</summary>
        public int VertexCapacity { get; private set; }

        /// <summary>Indices that may be written.</summary>
        public int IndexCapacity { get; private set; }

        /// <summary>Bytes of GPU memory.</summary>
        public long GpuBytes => GpuBuffers.Size(vertices, indices, drawArguments, emitArguments);

        /// <summary>Sets how much may be written and makes room for it. Where a buffer must be made anew, nothing is drawn until the next complete surface.</summary>
        public void Reserve(int vertexCapacity, int indexCapacity)
        {
            VertexCapacity = vertexCapacity;
            IndexCapacity = indexCapacity;
            if (vertices != null && vertices.count >= vertexCapacity && indices.count >= indexCapacity)
                return;
            GpuBuffers.Reserve(ref vertices, "SurfaceVertices", vertexCapacity, PackedSurfaceVertex.Stride);
            if (indices == null || indices.count < indexCapacity)
            {
                GpuBuffers.Dispose(ref indices);
                indices = GpuBuffers.Create("SurfaceIndices", indexCapacity, sizeof(uint), GraphicsBuffer.Target.Index | GraphicsBuffer.Target.Raw);
            }
            drawArguments.SetData(NothingDrawn);
        }

        public void Dispose()
        {
            GpuBuffers.Dispose(ref vertices);
            GpuBuffers.Dispose(ref indices);
            GpuBuffers.Dispose(ref drawArguments);
            GpuBuffers.Dispose(ref emitArguments);
        }
    }
}
