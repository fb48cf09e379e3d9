using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>A piece of a height field as triangles.</summary>
    internal static class TerrainMesh
    {
        /// <summary>
        /// Two triangles a cell, parted from its corner at the smallest x and z to that at the largest, as Unity's terrains are. Without
        /// holes the piece is closed by walls down to a floor and has an inside; with holes it is a sheet.
        /// </summary>
        /// <param name="heights">Heights [m] by row (z) and column (x) of corners.</param>
        /// <param name="surface">By row and column of a cell: false is a hole.</param>
        /// <param name="corner">Where the height 0 of the first corner is [m].</param>
        /// <param name="cellX">Edge of a cell along x [m].</param>
        /// <param name="cellZ">Edge of a cell along z [m].</param>
        /// <param name="floor">Height of the floor over that of the first corner, below all heights [m].</param>
        public static TriangleMesh Make(float[,] heights, bool[,] surface, Vector3 corner, float cellX, float cellZ, float floor)
        {
            int rows = heights.GetLength(0), columns = heights.GetLength(1), holes = Holes(surface), cells = (rows - 1) * (columns - 1);
            int rim = holes > 0 ? 0 : 2 * (rows + columns - 2);
            var vertices = new Vector3[rows * columns + (rim > 0 ? rim + 1 : 0)];
            var indices = new int[6 * (cells - holes) + 9 * rim];
            for (int z = 0; z < rows; z++)
                for (int x = 0; x < columns; x++) vertices[z * columns + x] = corner + new Vector3(x * cellX, heights[z, x], z * cellZ);

            int next = 0;
            for (int z = 0; z + 1 < rows; z++)
                for (int x = 0; x + 1 < columns; x++)
                {
                    if (!surface[z, x]) continue;
                    int low = z * columns + x, high = low + columns + 1;
                    Add(indices, ref next, low, high - 1, high);
                    Add(indices, ref next, low, high, low + 1);
                }
            if (rim > 0) Close(vertices, indices, next, rows, columns, corner.y + floor);
            return new TriangleMesh(vertices, indices, rim > 0);
        }

        // Walls from the rim down, and a fan between their feet.
        private static void Close(Vector3[] vertices, int[] indices, int next, int rows, int columns, float floor)
        {
            int rim = 2 * (rows + columns - 2), foot = rows * columns, middle = vertices.Length - 1;
            vertices[middle] = 0.5f * (vertices[0] + vertices[foot - 1]);
            vertices[middle].y = floor;
            for (int i = 0; i < rim; i++)
            {
                int j = (i + 1) % rim, p = Rim(i, rows, columns), q = Rim(j, rows, columns);
                vertices[foot + i] = new Vector3(vertices[p].x, floor, vertices[p].z);
                Add(indices, ref next, q, p, foot + i);
                Add(indices, ref next, q, foot + i, foot + j);
                Add(indices, ref next, middle, foot + j, foot + i);
            }
        }

        // Corners round the rim in the direction in which the surface's triangles run along it.
        private static int Rim(int i, int rows, int columns)
        {
            int up = rows - 1, along = columns - 1;
            if (i < up) return i * columns;
            if (i < up + along) return up * columns + i - up;
            if (i < 2 * up + along) return (2 * up + along - i) * columns + along;
            return 2 * (up + along) - i;
        }

        private static int Holes(bool[,] surface)
        {
            int holes = 0;
            foreach (bool solid in surface) holes += solid ? 0 : 1;
            return holes;
        }

        private static void Add(int[] indices, ref int next, int a, int b, int c)
        {
            indices[next++] = a;
            indices[next++] = b;
            indices[next++] = c;
        }
    }
}
