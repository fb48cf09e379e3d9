using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A mesh of known shape in the buffers of a sparse surface.</summary>
    internal sealed class UploadedSurface : IDisposable
    {
        private const float LargestShort = 32767f;

        private readonly List<Vector3> positions = new List<Vector3>();
        private readonly List<Vector3> normals = new List<Vector3>();
        private readonly List<uint> indices = new List<uint>();
        private GraphicsBuffer vertexBuffer, indexBuffer, arguments;

        public SurfaceBuffers Buffers
        {
            get
            {
                if (vertexBuffer == null) Upload();
                return new SurfaceBuffers(vertexBuffer, indexBuffer, arguments);
            }
        }

        /// <summary>Adds a closed box.</summary>
        public UploadedSurface Box(Vector3 centre, Vector3 size)
        {
            for (int axis = 0; axis < 3; axis++)
            {
                Vector3 outwards = Vector3.zero, u = Vector3.zero, v = Vector3.zero;
                outwards[axis] = 0.5f * size[axis];
                u[(axis + 1) % 3] = 0.5f * size[(axis + 1) % 3];
                v[(axis + 2) % 3] = 0.5f * size[(axis + 2) % 3];
                Quad(centre + outwards, u, v, outwards.normalized);
                Quad(centre - outwards, v, u, -outwards.normalized);
            }
            return this;
        }

        /// <summary>Adds a rectangle: centre, half edges, and any normal; its front is where u x v points.</summary>
        public UploadedSurface Quad(Vector3 centre, Vector3 u, Vector3 v, Vector3 normal)
        {
            uint first = (uint)positions.Count;
            foreach (Vector3 corner in new[] { -u - v, u - v, u + v, -u + v }) Add(centre + corner, normal);
            indices.AddRange(new[] { first, first + 1, first + 2, first, first + 2, first + 3 });
            return this;
        }

        /// <summary>Adds a surface seen from above, over a square around the origin: height and normal go by x.</summary>
        public UploadedSurface Waves(float width, int strips, Func<float, float> height, Func<float, Vector3> normal)
        {
            uint first = (uint)positions.Count;
            for (uint i = 0; i <= strips; i++)
            {
                float x = width * (i / (float)strips - 0.5f);
                Add(new Vector3(x, height(x), -0.5f * width), normal(x));
                Add(new Vector3(x, height(x), 0.5f * width), normal(x));
                uint a = first + 2 * i;
                if (i < strips) indices.AddRange(new[] { a, a + 1, a + 3, a, a + 3, a + 2 });
            }
            return this;
        }

        /// <summary>Adds a closed ball of flat rings.</summary>
        public UploadedSurface Ball(Vector3 centre, float radius, int rings)
        {
            int sides = 2 * rings;
            uint first = (uint)positions.Count;
            for (int ring = 0; ring <= rings; ring++)
            {
                for (int side = 0; side <= sides; side++)
                {
                    float polar = Mathf.PI * ring / rings, around = 2f * Mathf.PI * side / sides;
                    var normal = new Vector3(Mathf.Sin(polar) * Mathf.Cos(around), Mathf.Cos(polar), Mathf.Sin(polar) * Mathf.Sin(around));
                    Add(centre + radius * normal, normal);
                }
            }
            for (uint ring = 0; ring < rings; ring++)
            {
                for (uint side = 0; side < sides; side++)
                {
                    uint a = first + ring * (uint)(sides + 1) + side, b = a + (uint)sides + 1;
                    indices.AddRange(new[] { a, a + 1, b, a + 1, b + 1, b });
                }
            }
            return this;
        }

        public void Dispose()
        {
            GpuBuffers.Dispose(ref vertexBuffer);
            GpuBuffers.Dispose(ref indexBuffer);
            GpuBuffers.Dispose(ref arguments);
        }

        private void Add(Vector3 position, Vector3 normal)
        {
            positions.Add(position);
            normals.Add(normal.normalized);
        }

        private void Upload()
        {
            var packed = new PackedSurfaceVertex[positions.Count];
            for (int i = 0; i < packed.Length; i++)
            {
                packed[i] = new PackedSurfaceVertex { Position = positions[i], PackedNormal = Octahedral(normals[i]) };
            }
            vertexBuffer = GpuBuffers.Create("Vertices", packed.Length, PackedSurfaceVertex.Stride);
            indexBuffer = GpuBuffers.Create("Indices", indices.Count, sizeof(uint), GraphicsBuffer.Target.Index);
            arguments = GpuBuffers.CreateArguments("Arguments", 5);
            vertexBuffer.SetData(packed);
            indexBuffer.SetData(indices.ToArray());
            arguments.SetData(new[] { (uint)indices.Count, 1u, 0u, 0u, 0u });
        }

        private static uint Octahedral(Vector3 n)
        {
            n /= Mathf.Abs(n.x) + Mathf.Abs(n.y) + Mathf.Abs(n.z);
            if (n.z < 0f)
            {
                n = new Vector3((1f - Mathf.Abs(n.y)) * (n.x >= 0f ? 1f : -1f), (1f - Mathf.Abs(n.x)) * (n.y >= 0f ? 1f : -1f), 0f);
            }
            return Short(n.x) | Short(n.y) << 16;
        }

        private static uint Short(float value) => (ushort)(short)Mathf.RoundToInt(value * LargestShort);
    }
}
