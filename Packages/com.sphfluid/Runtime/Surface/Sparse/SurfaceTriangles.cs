using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A vertex of the sparse surface; mirrors the struct of Shaders/Surface/Sparse/PackedSurfaceVertex.hlsl.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct PackedSurfaceVertex
    {
        /// <summary>Bytes of one element.</summary>
        public const int Stride = 16;

        private const float Largest = 32767f;

        /// <summary>Position [m], simulation space.</summary>
        public Vector3 Position;

        /// <summary>Octahedral normal out of the liquid, 16 bits x (low) and 16 bits y.</summary>
        public uint PackedNormal;

        /// <summary>Unit normal out of the liquid.</summary>
        public Vector3 Normal
        {
            get
            {
                float x = (short)(PackedNormal & 0xffff) / Largest;
                float y = (short)(PackedNormal >> 16) / Largest;
                float z = 1f - Mathf.Abs(x) - Mathf.Abs(y);
                float fold = Mathf.Max(-z, 0f);
                return new Vector3(x - (x >= 0f ? fold : -fold), y - (y >= 0f ? fold : -fold), z).normalized;
            }
        }
    }

    /// <summary>
    /// The triangles of a sparse surface on the GPU: vertices, indices and the arguments of an indexed indirect draw.
    /// </summary>
    internal sealed class SurfaceTriangles : BufferSet
    {
        private const int DrawArgumentCount = 5;
        private const int DispatchArgumentCount = 3;

        // Of a block's range, SurfaceBlocks.Ranges.
        private const int RangeLength = 4;
        private const int FirstIndex = 2;
        private const int IndexCount = 3;

        private static readonly uint[] NothingDrawn = new uint[DrawArgumentCount];

        private FluidBuffer vertices, indices;

        public SurfaceTriangles()
        {
            DrawArguments = Add("DrawArguments", DrawArgumentCount, sizeof(uint), Arguments);
            EmitArguments = Add("EmitArguments", DispatchArgumentCount, sizeof(uint), Arguments);
            Reserve(1, 1);
        }

        /// <summary>Most vertices that a buffer of this device holds.</summary>
        public static int DeviceVertexLimit =>
            (int)Math.Min(SystemInfo.maxGraphicsBufferSize / PackedSurfaceVertex.Stride, int.MaxValue);

        /// <summary>Most indices that a buffer of this device holds.</summary>
        public static int DeviceIndexLimit =>
            (int)Math.Min(SystemInfo.maxGraphicsBufferSize / sizeof(uint), int.MaxValue);

        /// <summary><see cref="PackedSurfaceVertex"/> each; equal ones only where blocks touch.</summary>
        public FluidBuffer Vertices => vertices;

        /// <summary>uint each, three a triangle.</summary>
        public FluidBuffer Indices => indices;

        /// <summary>One <see cref="GraphicsBuffer.IndirectDrawIndexedArgs"/>.</summary>
        public FluidBuffer DrawArguments { get; }

        /// <summary>Groups along x, y and z of a dispatch with a group a block.</summary>
        public FluidBuffer EmitArguments { get; }

        /// <summary>Vertices that may be written.</summary>
        public int VertexCapacity { get; private set; }

        /// <summary>Indices that may be written.</summary>
        public int IndexCapacity { get; private set; }

        /// <summary>
        /// Sets how much may be written and grows the buffers to it. Where a buffer is made anew, nothing is drawn
        /// until the next complete surface.
        /// </summary>
        public void Reserve(int vertexCapacity, int indexCapacity)
        {
            VertexCapacity = vertexCapacity;
            IndexCapacity = indexCapacity;
            if (vertices != null && vertices.Count >= vertexCapacity && indices.Count >= indexCapacity) return;
            Grow(ref vertices, "SurfaceVertices", vertexCapacity, PackedSurfaceVertex.Stride);
            Grow(ref indices, "SurfaceIndices", indexCapacity, sizeof(uint),
                GraphicsBuffer.Target.Index | GraphicsBuffer.Target.Raw);
            DrawArguments.SetData(NothingDrawn);
        }

        /// <summary>
        /// Waits for the GPU and reads a complete surface. All triangles around a vertex share it: blocks compute the
        /// vertices on a common face alike, so equal bits of the position identify them. Slots are given in no
        /// particular order; triangles are read in the order of the blocks, so that the same surface gives the same
        /// mesh.
        /// </summary>
        public SurfaceMesh Read(SurfaceBlocks blocks, in SurfaceStatus status)
        {
            var numbers = new int[status.Blocks];
            var ranges = new uint[RangeLength * status.Blocks];
            var read = new PackedSurfaceVertex[status.Vertices];
            var corners = new int[3 * status.Triangles];
            if (corners.Length > 0)
            {
                blocks.List.GetData(numbers);
                blocks.Ranges.GetData(ranges);
                vertices.GetData(read);
                indices.GetData(corners);
            }
            return Weld(read, corners, InBlockOrder(numbers, ranges));
        }

        // Runs of indices, those of the block with the lowest number first.
        private static (int First, int Count)[] InBlockOrder(int[] blockNumbers, uint[] ranges)
        {
            var runs = new (int First, int Count)[blockNumbers.Length];
            for (int slot = 0; slot < runs.Length; slot++)
            {
                runs[slot] = ((int)ranges[RangeLength * slot + FirstIndex],
                    (int)ranges[RangeLength * slot + IndexCount]);
            }
            Array.Sort(blockNumbers, runs);
            return runs;
        }

        private static SurfaceMesh Weld(PackedSurfaceVertex[] read, int[] corners, (int First, int Count)[] runs)
        {
            var numbers = new Dictionary<(int, int, int), int>(read.Length);
            var shared = new int[read.Length];
            var positions = new List<Vector3>(read.Length);
            var normals = new List<Vector3>(read.Length);
            var welded = new List<int>(corners.Length);
            Array.Fill(shared, -1);
            foreach ((int first, int count) in runs)
            {
                for (int i = first; i < first + count; i++)
                {
                    ref int number = ref shared[corners[i]];
                    if (number < 0) number = NumberOf(read[corners[i]], numbers, positions, normals);
                    welded.Add(number);
                }
            }
            return new SurfaceMesh(positions.ToArray(), normals.ToArray(), welded.ToArray());
        }

        private static int NumberOf(in PackedSurfaceVertex vertex, Dictionary<(int, int, int), int> numbers,
            List<Vector3> positions, List<Vector3> normals)
        {
            Vector3 p = vertex.Position;
            (int, int, int) bits = (BitConverter.SingleToInt32Bits(p.x), BitConverter.SingleToInt32Bits(p.y),
                BitConverter.SingleToInt32Bits(p.z));
            if (!numbers.TryGetValue(bits, out int number))
            {
                number = positions.Count;
                numbers.Add(bits, number);
                positions.Add(p);
                normals.Add(vertex.Normal);
            }
            return number;
        }
    }
}
