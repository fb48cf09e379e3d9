using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Finds the iso value at which Zhu and Bridson's field puts the top of a pool half a spacing above its last layer: the mean over a
    /// perfect lattice and six positions at which its layers lie between the planes of the grid.
    /// </summary>
    internal static class ZhuBridsonCalibration
    {
        private const int Phases = 6, Margin = 4, Rim = 5, Bisections = 24;

        // What the phases also shift across, in cells: columns cross the lattice everywhere.
        private static readonly Vector3 across = new Vector3(0.178f, 0f, 0.731f);

        /// <summary>The iso value.</summary>
        /// <param name="cell">Edge of a cell [dx].</param>
        public static float Iso(float cell)
        {
            var size = new Vector3Int(14, 8, 14);
            Vector3 domain = size + 2 * Margin * Vector3Int.one;
            var scale = new SurfaceScale();
            var samples = new List<(float[] Values, double Level)>();
            SurfaceGrid grid = SurfaceGrid.OverDomain(SurfaceScale.Spacing * domain, cell * SurfaceScale.Spacing);
            for (int phase = 0; phase < Phases; phase++)
            {
                Vector3 shift = Margin * Vector3.one + cell * ((phase + 0.5f) / Phases * Vector3.up + phase * across);
                SurfaceState state = scale.Of(domain, CaseLattice.Box(size, 1.0, shift));
                samples.Add((ZhuBridsonField.Sample(state.Frames[0], state.Settings, grid), SurfaceScale.Height(state, shift.y + size.y)));
            }
            float low = 0f, high = 1f;
            for (int i = 0; i < Bisections; i++)
            {
                float iso = 0.5f * (low + high);
                if (MeanError(samples, grid, iso) > 0.0)
                    low = iso;
                else
                    high = iso;
            }
            return 0.5f * (low + high);
        }

        private static double MeanError(List<(float[] Values, double Level)> samples, SurfaceGrid grid, float iso)
        {
            int rim = Mathf.CeilToInt((Margin + Rim) * SurfaceScale.Spacing / grid.CellSize.x);
            double sum = 0.0;
            int count = 0;
            foreach ((float[] values, double level) in samples)
            {
                for (int z = rim; z <= grid.Cells.z - rim; z++)
                    for (int x = rim; x <= grid.Cells.x - rim; x++)
                    {
                        sum += Top(values, grid, x, z, iso) - level;
                        count++;
                    }
            }
            return sum / count;
        }

        // Where a column of the grid enters the liquid from above; the floor where it does not.
        private static double Top(float[] values, SurfaceGrid grid, int x, int z, float iso)
        {
            for (int y = grid.Cells.y - 1; y >= 0; y--)
            {
                float below = values[grid.Index(x, y, z)], above = values[grid.Index(x, y + 1, z)];
                if (below >= iso) return grid.Position(x, y, z).y + (below - iso) / (below - above) * grid.CellSize.y;
            }
            return grid.Minimum.y;
        }
    }
}
