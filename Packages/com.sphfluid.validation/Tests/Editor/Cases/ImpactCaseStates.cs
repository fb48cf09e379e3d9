using System;
using System.Collections.Generic;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>States with a known front, a known height at the closed end and known heights at gauges.</summary>
    internal static class ImpactCaseStates
    {
        /// <summary>
        /// A layer on the floor out to a front, and six rows at the closed end up to a height; rows are evenly spaced, by dx or less.
        /// </summary>
        public static List<Vector3> Fallen(Vector3 domain, double front, double height, double spacing, int slabRows)
        {
            var positions = new List<Vector3>();
            int along = (int)Math.Ceiling(front / spacing), up = (int)Math.Ceiling(height / spacing);
            for (int z = 0; z < slabRows; z++)
            {
                for (int i = 0; i < along; i++)
                {
                    positions.Add(new Vector3((float)Even(i, along, front, spacing), (float)(0.5 * spacing), (float)((z + 0.5) * spacing)) -
                        0.5f * domain);
                }
                for (int i = 6; i < 6 * up; i++)
                {
                    positions
                        .Add(new Vector3((float)((i % 6 + 0.5) * spacing), (float)Even(i / 6, up, height, spacing),
                            (float)((z + 0.5) * spacing)) - 0.5f * domain);
                }
            }
            return positions;
        }

        /// <summary>A column of three by three particles on the floor at each gauge of MARIN's tank.</summary>
        public static List<Vector3> Columns(Vector3 domain, double[] heights, double spacing)
        {
            var positions = new List<Vector3>();
            for (int gauge = 0; gauge < heights.Length; gauge++)
            {
                int count = 9 * (int)Math.Round(heights[gauge] / spacing);
                for (int i = 0; i < count; i++)
                {
                    positions.Add(new Vector3(-0.5f * domain.x + (float)(MarinHeights.Gauges[gauge] + (i % 3 - 1) * spacing),
                        -0.5f * domain.y + (float)((i / 9 + 0.5) * spacing), (float)((i / 3 % 3 - 1) * spacing)));
                }
            }
            return positions;
        }

        public static FluidSnapshot State(IReadOnlyList<Vector3> positions) => WallCaseStates.State(positions.Count, i => positions[i]);

        // From half a spacing to half a spacing before the end.
        private static double Even(int i, int count, double length, double spacing) =>
            0.5 * spacing + (count == 1 ? 0.0 : i * (length - spacing) / (count - 1));
    }
}
