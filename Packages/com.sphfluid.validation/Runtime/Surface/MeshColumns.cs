using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A raster of vertical lines; where a mesh cuts each of them highest.</summary>
    public sealed class MeshColumns
    {
        // Columns never lie in planes of a cell grid that starts at the raster's corner, where they would hit edges of triangles.
        private const double Offset = 0.37;

        private readonly double left, back, spacing;

        /// <summary>A raster.</summary>
        /// <param name="region">The region in x and z [m]: its x and y.</param>
        /// <param name="spacing">Distance of the columns [m].</param>
        /// <exception cref="ArgumentException">The region holds no column.</exception>
        public MeshColumns(Rect region, float spacing)
        {
            (left, back, this.spacing) = (region.xMin + Offset * spacing, region.yMin + Offset * spacing, spacing);
            Across = CountIn(region.width);
            Deep = CountIn(region.height);
            if (Across < 1 || Deep < 1)
            {
                throw new ArgumentException($"A raster of columns {spacing} m apart has none in {region}. Choose a larger region.",
                    nameof(region));
            }
        }

        /// <summary>Columns along x.</summary>
        public int Across { get; }

        /// <summary>Columns along z.</summary>
        public int Deep { get; }

        /// <summary>Heights of a mesh.</summary>
        /// <param name="mesh">Any mesh.</param>
        /// <returns>Highest cut of each column [m], x fastest; not a number where the column misses the mesh.</returns>
        public double[] Heights(SurfaceMesh mesh)
        {
            var heights = new double[Across * Deep];
            for (int i = 0; i < heights.Length; i++) heights[i] = double.NaN;
            for (int i = 0; i < mesh.Indices.Length; i += 3)
            {
                Raise(heights, mesh.Positions[mesh.Indices[i]], mesh.Positions[mesh.Indices[i + 1]], mesh.Positions[mesh.Indices[i + 2]]);
            }
            return heights;
        }

        private void Raise(double[] heights, Vector3 a, Vector3 b, Vector3 c)
        {
            double area = Twice(a, b, c.x, c.z);
            if (area == 0.0) return;
            int lastX = Last(Math.Max(a.x, Math.Max(b.x, c.x)), left, Across), lastZ = Last(Math.Max(a.z, Math.Max(b.z, c.z)), back, Deep);
            for (int iz = First(Math.Min(a.z, Math.Min(b.z, c.z)), back); iz <= lastZ; iz++)
                for (int ix = First(Math.Min(a.x, Math.Min(b.x, c.x)), left); ix <= lastX; ix++)
                {
                    double x = left + ix * spacing, z = back + iz * spacing;
                    double u = Twice(b, c, x, z) / area, v = Twice(c, a, x, z) / area, w = 1.0 - u - v;
                    if (u < 0.0 || v < 0.0 || w < 0.0) continue;
                    double height = u * a.y + v * b.y + w * c.y;
                    int column = iz * Across + ix;
                    if (!(heights[column] >= height)) heights[column] = height;
                }
        }

        private int First(double least, double origin) => (int)Math.Max(0.0, Math.Ceiling((least - origin) / spacing));

        private int Last(double greatest, double origin, int count) => (int)Math.Min(count - 1, Math.Floor((greatest - origin) / spacing));

        private int CountIn(double length) => (int)Math.Floor(length / spacing - Offset) + 1;

        // Twice the signed area of the triangle p, q, (x, z) seen from above.
        private static double Twice(Vector3 p, Vector3 q, double x, double z) =>
            ((double)q.x - p.x) * (z - p.z) - ((double)q.z - p.z) * (x - p.x);
    }
}
