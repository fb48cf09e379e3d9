using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Finds how deep solids are behind their triangles, along the normal from four places of each. A triangle of a deep solid is part of
    /// its boundary from both sides; of a thin plate only the side counts that liquid sees, or its back would take away what its front
    /// adds.
    /// </summary>
    [BurstCompile(FloatPrecision.High, FloatMode.Strict)]
    internal struct BodyDepthJob : IJob
    {
        // Of a corner's weight, from the middle: there a wedge is thin.
        private const float Outwards = 0.8f;

        public BodyCells Cells;
        public uint FirstReference;
        public uint FirstTriangle;

        /// <summary>A solid is deep from here on [m]: as far as a wall is felt.</summary>
        public float Depth;

        [ReadOnly] public NativeArray<BodyTriangle> Triangles;

        /// <summary>Number of each triangle's solid; 0: none.</summary>
        [ReadOnly] public NativeArray<int> Solids;

        [ReadOnly] public NativeArray<uint> Starts, References;

        /// <summary>Of triangles of solids with both bits of <see cref="MeshSurfaces.Deep"/>; those of thin sides are taken away.</summary>
        public NativeArray<uint> Edges;

        public void Execute()
        {
            for (int t = 0; t < Triangles.Length; t++)
            {
                if (Solids[t] == 0) continue;
                BodyTriangle triangle = Triangles[t];
                Vector3 middle = (triangle.A + triangle.B + triangle.C) / 3f;
                uint deep = MeshSurfaces.Deep & Seen(t, middle) & Seen(t, Vector3.Lerp(middle, triangle.A, Outwards)) &
                    Seen(t, Vector3.Lerp(middle, triangle.B, Outwards)) &
                    Seen(t, Vector3.Lerp(middle, triangle.C, Outwards));
                Edges[t] &= ~MeshSurfaces.Deep | deep;
            }
        }

        // The sides on which nothing of the solid is near; both where no cell is.
        private uint Seen(int t, Vector3 place)
        {
            var normal = new Vector3(Triangles[t].NormalX, Triangles[t].NormalY, Triangles[t].NormalZ);
            int cell = Cells.At(place);
            uint deep = MeshSurfaces.Deep;
            if (cell < 0) return deep;
            for (uint r = Starts[cell]; r < Starts[cell + 1]; r++)
            {
                int other = (int)(References[(int)(r - FirstReference)] - FirstTriangle);
                if (other == t || Solids[other] != Solids[t] ||
                    !TriangleMath.LineCrosses(place, normal, Triangles[other].A, Triangles[other].B, Triangles[other].C, out float along))
                {
                    continue;
                }
                if (along < 0f && along > -Depth) deep &= ~MeshSurfaces.DeepBehind;
                if (along > 0f && along < Depth) deep &= ~MeshSurfaces.DeepAhead;
            }
            return deep;
        }
    }
}
