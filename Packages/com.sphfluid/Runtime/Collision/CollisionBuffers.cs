using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// GPU copies of the collision triangles and collider ranges. They hold at least one element: a kernel's buffer must be bound.
    /// </summary>
    internal sealed class CollisionBuffers : IDisposable
    {
        public GraphicsBuffer Triangles { get; private set; }
        public GraphicsBuffer Colliders { get; private set; }

        /// <summary>Bytes of both buffers.</summary>
        public long Bytes => GpuBuffers.Size(Triangles, Colliders);

        /// <summary>Bytes that both take for as many triangles and colliders.</summary>
        public static long PlannedBytes(int triangles, int colliders) =>
            GpuBuffers.BytesOf(triangles, CollisionTriangle.Stride) + GpuBuffers.BytesOf(colliders, CollisionCollider.Stride);

        public void Upload(List<CollisionTriangle> triangles, List<CollisionCollider> colliders)
        {
            Triangles = Fill(Triangles, triangles, CollisionTriangle.Stride, "Fluid Collision Triangles");
            Colliders = Fill(Colliders, colliders, CollisionCollider.Stride, "Fluid Collision Colliders");
        }

        public void Dispose()
        {
            Triangles?.Dispose();
            Colliders?.Dispose();
            Triangles = Colliders = null;
        }

        private static GraphicsBuffer Fill<T>(GraphicsBuffer buffer, List<T> items, int stride, string name) where T : struct
        {
            if (buffer == null || buffer.count < items.Count)
            {
                buffer?.Dispose();
                buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, Math.Max(1, items.Count), stride) { name = name };
            }
            if (items.Count > 0) buffer.SetData(items, 0, 0, items.Count);
            return buffer;
        }
    }
}
