using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Y. Zhu and R. Bridson, "Animating sand as a fluid" (2005), on the CPU and for comparison: the distance of a point from the weighted
    /// mean of the particles around it, by the weights (1 − q²)³ with q = r/R. Here 1 − distance/R, so that the liquid has the larger
    /// values and air has 0.
    /// </summary>
    internal static class ZhuBridsonField
    {
        // R/dx: 33 particles of a lattice, as the sparse surface's smooth field has them.
        private const float SupportRatio = 2f;

        /// <summary>The field.</summary>
        /// <param name="positions">Particles [m].</param>
        /// <param name="settings">Domain and spacing; no periodic axes.</param>
        /// <param name="grid">Where it is sampled.</param>
        /// <returns>0 to 1 at each grid vertex, x fastest.</returns>
        public static float[] Sample(Vector3[] positions, in FluidSolverSettings settings, SurfaceGrid grid)
        {
            float radius = SupportRatio * settings.Spacing;
            var weights = new float[grid.VertexCount];
            var sums = new Vector3[grid.VertexCount];
            foreach (Vector3 position in WithImages(positions, 0.5f * settings.DomainSize, radius))
            {
                Add(position, radius, grid, weights, sums);
            }
            var values = new float[grid.VertexCount];
            for (int i = 0; i < values.Length; i++)
            {
                values[i] = weights[i] > 0f ? Math.Max(0f, 1f - sums[i].magnitude / weights[i] / radius) : 0f;
            }
            return values;
        }

        private static void Add(Vector3 position, float radius, SurfaceGrid grid, float[] weights, Vector3[] sums)
        {
            Vector3 cell = grid.CellSize, from = position - grid.Minimum - radius * Vector3.one,
                to = position - grid.Minimum + radius * Vector3.one;
            Vector3Int first = Vector3Int.Max(Vector3Int.CeilToInt(Divided(from, cell)), Vector3Int.zero);
            Vector3Int last = Vector3Int.Min(Vector3Int.FloorToInt(Divided(to, cell)), grid.Cells);
            for (int z = first.z; z <= last.z; z++)
                for (int y = first.y; y <= last.y; y++)
                    for (int x = first.x; x <= last.x; x++)
                    {
                        Vector3 apart = position - grid.Position(x, y, z);
                        float t = 1f - apart.sqrMagnitude / (radius * radius);
                        if (t <= 0f) continue;
                        weights[grid.Index(x, y, z)] += t * t * t;
                        sums[grid.Index(x, y, z)] += t * t * t * apart;
                    }
        }

        // As if the liquid went on behind walls: what lies within reach of one is mirrored there, in corners twice and thrice.
        private static List<Vector3> WithImages(Vector3[] positions, Vector3 half, float reach)
        {
            var all = new List<Vector3>(positions);
            for (int axis = 0; axis < 3; axis++)
            {
                int count = all.Count;
                for (int i = 0; i < count; i++)
                {
                    Vector3 image = all[i];
                    if (half[axis] - Math.Abs(image[axis]) > reach) continue;
                    image[axis] = (image[axis] < 0f ? -2f : 2f) * half[axis] - image[axis];
                    all.Add(image);
                }
            }
            return all;
        }

        private static Vector3 Divided(Vector3 a, Vector3 b) => new Vector3(a.x / b.x, a.y / b.y, a.z / b.z);
    }
}
