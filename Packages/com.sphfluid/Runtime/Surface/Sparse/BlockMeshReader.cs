using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Reads a complete sparse surface back and joins what its blocks have in common.</summary>
    static class BlockMeshReader
    {
        // uint4 a block: first vertex, vertices, first index, indices.
        const int RangeLength = 4;
        const int FirstIndex = 2;
        const int IndexCount = 3;

        /// <summary>
        /// A mesh whose vertices are shared by all triangles around them: blocks compute those on a common face alike, so equal bits of the position tell them.
        /// Slots are handed out in no particular order; by the order of the blocks the same surface gives the same mesh.
        /// </summary>
        public static SurfaceMesh Read(SurfaceBlocks blocks, BlockMesh mesh, in SurfaceStatus status)
        {
            var numbers = new int[status.Blocks];
            var ranges = new uint[RangeLength * status.Blocks];
            var vertices = new PackedSurfaceVertex[status.Vertices];
            var indices = new int[3 * status.Triangles];
            if (indices.Length > 0)
            {
                blocks.List.GetData(numbers, 0, 0, numbers.Length);
                blocks.Ranges.GetData(ranges, 0, 0, ranges.Length);
                mesh.Vertices.GetData(vertices, 0, 0, vertices.Length);
                mesh.Indices.GetData(indices, 0, 0, indices.Length);
            }
            return Weld(vertices, indices, InBlockOrder(numbers, ranges));
        }

        static SurfaceMesh Weld(PackedSurfaceVertex[] vertices, int[] indices, (int First, int Count)[] runs)
        {
            var numbers = new Dictionary<(int, int, int), int>(vertices.Length);
            var shared = new int[vertices.Length];
            var positions = new List<Vector3>(vertices.Length);
            var normals = new List<Vector3>(vertices.Length);
            var welded = new List<int>(indices.Length);
            Array.Fill(shared, -1);
            foreach ((int first, int count) in runs)
            {
                for (int i = first; i < first + count; i++)
                {
                    ref int number = ref shared[indices[i]];
                    if (number < 0)
                        number = NumberOf(vertices[indices[i]], numbers, positions, normals);
                    welded.Add(number);
                }
            }
            return new SurfaceMesh(positions.ToArray(), normals.ToArray(), welded.ToArray());
        }

        static int NumberOf(in PackedSurfaceVertex vertex, Dictionary<(int, int, int), int> numbers, List<Vector3> positions, List<Vector3> normals)
        {
            Vector3 p = vertex.Position;
            (int, int, int) bits = (BitConverter.SingleToInt32Bits(p.x), BitConverter.SingleToInt32Bits(p.y), BitConverter.SingleToInt32Bits(p.z));
            if (!numbers.TryGetValue(bits, out int number))
            {
                number = positions.Count;
                numbers.Add(bits, number);
                positions.Add(p);
                normals.Add(vertex.Normal);
            }
            return number;
        }

        // Runs of indices, those of the block with the lowest number first.
        static (int First, int Count)[] InBlockOrder(int[] blockNumbers, uint[] ranges)
        {
            var runs = new (int First, int Count)[blockNumbers.Length];
            for (int slot = 0; slot < runs.Length; slot++)
                runs[slot] = ((int)ranges[RangeLength * slot + FirstIndex], (int)ranges[RangeLength * slot + IndexCount]);
            Array.Sort(blockNumbers, runs);
            return runs;
        }
    }
}
