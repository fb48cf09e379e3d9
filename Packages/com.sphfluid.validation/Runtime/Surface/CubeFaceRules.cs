using System;
using System.Collections.Generic;
using System.Linq;
using SphFluid.Laboratory;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// How the faces of a marching-cubes cube lie, and the outlines that a surface draws on them. Corners and edges have Bourke's
    /// numbers, as in <see cref="CubeNumbering"/>; the outlines are found here by themselves.
    /// </summary>
    internal static class CubeFaceRules
    {
        private const int Cases = 256, Edges = 12;

        // Bourke's corners go round the lower layer, then round the upper one.
        private static readonly Vector3Int[] offsets =
        {
            new Vector3Int(0, 0, 0), new Vector3Int(1, 0, 0), new Vector3Int(1, 1, 0), new Vector3Int(0, 1, 0),
            new Vector3Int(0, 0, 1), new Vector3Int(1, 0, 1), new Vector3Int(1, 1, 1), new Vector3Int(0, 1, 1),
        };

        // Corners of lower z, upper z, lower y, upper y, lower x, upper x, round each face in one sense seen from outside.
        private static readonly int[][] faces =
        {
            new[] { 0, 3, 2, 1 }, new[] { 4, 5, 6, 7 }, new[] { 0, 1, 5, 4 }, new[] { 3, 7, 6, 2 }, new[] { 0, 4, 7, 3 },
            new[] { 1, 2, 6, 5 },
        };

        // A bit a face for each case.
        private static readonly int[] cutByOneLoop = Enumerable.Range(0, Cases).Select(FindCutByOneLoop).ToArray();

        /// <summary>Number of faces.</summary>
        public static int Count => faces.Length;

        /// <summary>Where a corner of a cube lies.</summary>
        public static Vector3Int Offset(int corner) => offsets[corner];

        /// <summary>The step to the cube behind a face.</summary>
        public static Vector3Int Direction(int face)
        {
            Vector3Int sum = faces[face].Aggregate(Vector3Int.zero, (total, corner) => total + offsets[corner]);
            return sum / 2 - Vector3Int.one; // e.g. (2, 2, 0)/2 − 1 below
        }

        /// <summary>The face opposite to a face.</summary>
        public static int Opposite(int face) => face ^ 1;

        /// <summary>The corner at an offset of zeros and ones.</summary>
        public static int CornerAt(Vector3Int offset) => Array.IndexOf(offsets, offset);

        /// <summary>The edge between two corners.</summary>
        public static int EdgeBetween(int a, int b) => Enumerable.Range(0, Edges).First(edge =>
        {
            int first = CubeNumbering.EdgeCorners[2 * edge], second = CubeNumbering.EdgeCorners[2 * edge + 1];
            return first == a && second == b || first == b && second == a;
        });

        /// <summary>Whether, in a case, one outline passes all four edges of a face.</summary>
        public static bool IsCutByOneLoop(int index, int face) => (cutByOneLoop[index] >> face & 1) != 0;

        /// <summary>The closed outlines of a case: their cut edges in order.</summary>
        /// <param name="index">The case; a bit is set for each corner outside the liquid.</param>
        /// <param name="separated">Faces, a bit each, on which diagonal inside corners are kept apart, not joined.</param>
        public static List<List<int>> Outlines(int index, int separated = 0)
        {
            var after = new Dictionary<int, int>();
            for (int face = 0; face < Count; face++)
            {
                // Round the face, cut edges leave the liquid and enter it in turn. An outline runs from the edge that enters to the one
                // before it that leaves: it cuts off what is outside between them. To keep the inside apart it comes from the other one.
                int[] corners = faces[face];
                List<int> cut = Enumerable.Range(0, 4).Where(i => IsInside(index, corners[i]) != IsInside(index, corners[(i + 1) % 4]))
                    .ToList();
                for (int k = 0; k < cut.Count; k++)
                {
                    if (!IsInside(index, corners[cut[k]])) continue;
                    int other = cut[(k + ((separated >> face & 1) != 0 ? cut.Count - 1 : 1)) % cut.Count];
                    after[EdgeOf(corners, other)] = EdgeOf(corners, cut[k]);
                }
            }

            var outlines = new List<List<int>>();
            for (int start = 0; start < Edges; start++)
            {
                var outline = new List<int>();
                for (int edge = start; after.TryGetValue(edge, out int next); edge = next)
                {
                    after.Remove(edge);
                    outline.Add(edge);
                }

                if (outline.Count > 0) outlines.Add(outline);
            }

            return outlines;
        }

        private static bool IsInside(int index, int corner) => (index >> corner & 1) == 0;

        private static int EdgeOf(int[] corners, int side) => EdgeBetween(corners[side], corners[(side + 1) % 4]);

        private static int FindCutByOneLoop(int index)
        {
            List<List<int>> outlines = Outlines(index);
            return Enumerable.Range(0, Count)
                .Where(face => outlines.Any(outline => Enumerable.Range(0, 4).All(side => outline.Contains(EdgeOf(faces[face], side)))))
                .Sum(face => 1 << face);
        }
    }
}
