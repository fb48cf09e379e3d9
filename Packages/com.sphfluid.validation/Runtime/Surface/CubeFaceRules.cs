using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>How the faces of a marching-cubes cube lie, and what its outlines do on them.</summary>
    static class CubeFaceRules
    {
        const int Cases = 256;

        // A bit a face for each case.
        static readonly int[] cutByOneLoop = Enumerable.Range(0, Cases).Select(FindCutByOneLoop).ToArray();

        /// <summary>Number of faces.</summary>
        public static int Count => MarchingCubesTables.CubeFaces.Count;

        /// <summary>The step to the cube behind a face.</summary>
        public static Vector3Int Direction(int face)
        {
            Vector3Int sum = Vector3Int.zero;
            foreach (int corner in MarchingCubesTables.CubeFaces[face])
                sum += SurfaceGrid.CornerOffset(corner);
            return sum / 2 - Vector3Int.one; // e.g. (2, 2, 0)/2 − 1 below
        }

        /// <summary>The face opposite to a face.</summary>
        public static int Opposite(int face) => face ^ 1;

        /// <summary>The corner at an offset of zeros and ones.</summary>
        public static int CornerAt(Vector3Int offset) => Enumerable.Range(0, 8).First(corner => SurfaceGrid.CornerOffset(corner) == offset);

        /// <summary>Whether, in a case, one outline passes all four edges of a face.</summary>
        public static bool IsCutByOneLoop(int index, int face) => (cutByOneLoop[index] >> face & 1) != 0;

        static int FindCutByOneLoop(int index)
        {
            int faces = 0;
            List<List<int>> loops = MarchingCubesTables.Loops(index);
            for (int face = 0; face < Count; face++)
            {
                int[] corners = MarchingCubesTables.CubeFaces[face];
                int[] edges = Enumerable.Range(0, 4).Select(i => MarchingCubesTables.EdgeBetween(corners[i], corners[(i + 1) % 4])).ToArray();
                if (loops.Any(loop => edges.All(loop.Contains)))
                    faces |= 1 << face;
            }
            return faces;
        }
    }
}
