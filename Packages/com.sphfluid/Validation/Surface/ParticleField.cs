using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// A surface field of the literature on the CPU, for comparison: numbers at the vertices of a grid, 0 where no particle is near and larger
    /// towards the liquid. R is the kernels' support radius and q = r/R.
    /// </summary>
    abstract class ParticleField
    {
        /// <summary>The field of some particles.</summary>
        /// <param name="particles">The particles and their images behind walls.</param>
        /// <param name="grid">Where it is wanted.</param>
        /// <returns>A number a grid vertex, x fastest.</returns>
        public abstract float[] Sample(NeighbourSums particles, SurfaceGrid grid);

        /// <summary>Calls for each grid vertex within a box about a point.</summary>
        /// <param name="grid">The grid.</param>
        /// <param name="centre">The point [m].</param>
        /// <param name="extent">Half edges of the box [m].</param>
        /// <param name="visit">Takes the vertex's index and the way from it to the centre [m].</param>
        protected static void EachVertex(SurfaceGrid grid, Vector3 centre, Vector3 extent, Action<int, Vector3> visit)
        {
            Vector3 cell = grid.CellSize, from = centre - extent - grid.Minimum, to = centre + extent - grid.Minimum;
            Vector3Int first = Vector3Int.Max(Vector3Int.CeilToInt(Divided(from, cell)), Vector3Int.zero);
            Vector3Int last = Vector3Int.Min(Vector3Int.FloorToInt(Divided(to, cell)), grid.Cells);
            for (int z = first.z; z <= last.z; z++)
            for (int y = first.y; y <= last.y; y++)
            for (int x = first.x; x <= last.x; x++)
                visit(grid.Index(x, y, z), centre - grid.Position(x, y, z));
        }

        static Vector3 Divided(Vector3 a, Vector3 b) => new Vector3(a.x / b.x, a.y / b.y, a.z / b.z);
    }
}
