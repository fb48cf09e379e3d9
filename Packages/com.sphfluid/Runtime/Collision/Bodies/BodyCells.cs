using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Cells over a body: equal cubes that each look a distance beyond themselves. Blittable, for jobs.</summary>
    internal struct BodyCells
    {
        // What rounding may move a cell's border by.
        public const double Slack = 1e-4;

        public Vector3 Origin; // m
        public float Side;     // m
        public int CountX;
        public int CountY;
        public int CountZ;
        public float Reach; // how far a cell looks, m

        public int Count => CountX * CountY * CountZ;

        /// <summary>Number of the cell at a place; -1 where none is.</summary>
        public int At(Vector3 place)
        {
            Vector3 cell = (place - Origin) / Side;
            int x = Mathf.FloorToInt(cell.x), y = Mathf.FloorToInt(cell.y), z = Mathf.FloorToInt(cell.z);
            return x >= 0 && x < CountX && y >= 0 && y < CountY && z >= 0 && z < CountZ ? (z * CountY + y) * CountX + x : -1;
        }

        /// <summary>Cells of a side over a box, larger ones where these would be more than <paramref name="most"/>.</summary>
        public static BodyCells Over(Vector3 low, Vector3 high, float reach, float side, long most)
        {
            Vector3 size = Vector3.Max(high - low, Vector3.zero);
            while (Math.Ceiling(size.x / side) * Math.Ceiling(size.y / side) * Math.Ceiling(size.z / side) > most) side *= 1.26f;
            return new BodyCells
            {
                Origin = low,
                Side = side,
                CountX = Math.Max(1, Mathf.CeilToInt(size.x / side)),
                CountY = Math.Max(1, Mathf.CeilToInt(size.y / side)),
                CountZ = Math.Max(1, Mathf.CeilToInt(size.z / side)),
                Reach = reach,
            };
        }
    }

    /// <summary>
    /// Goes through the cells that list a triangle whose corners go straight from a start to an end: those whose cube is within the reach
    /// of the box of all six and of the slab along the first normal that holds them.
    /// </summary>
    internal struct BodyCellWalk
    {
        private readonly BodyCells cells;
        private readonly BodyTriangle triangle;
        private readonly double reachSquared, lowest, highest; // of a cell's cube from the box, and of its middle along the normal
        private readonly Vector3 min, max;
        private readonly int x0, x1, y0, y1, z1;
        private int x, y, z;

        public BodyCellWalk(in BodyCells cells, in BodyTriangle triangle, in BodyTriangle end)
        {
            this.cells = cells;
            this.triangle = triangle;
            double reach = cells.Reach * (1.0 + BodyCells.Slack), slack = BodyCells.Slack * cells.Side;
            reachSquared = (reach + slack) * (reach + slack);
            min = Vector3.Min(triangle.Low, end.Low);
            max = Vector3.Max(triangle.High, end.High);
            x0 = Cell((min.x - reach - cells.Origin.x) / cells.Side, cells.CountX);
            x1 = Cell((max.x + reach - cells.Origin.x) / cells.Side, cells.CountX);
            y0 = Cell((min.y - reach - cells.Origin.y) / cells.Side, cells.CountY);
            y1 = Cell((max.y + reach - cells.Origin.y) / cells.Side, cells.CountY);
            int z0 = Cell((min.z - reach - cells.Origin.z) / cells.Side, cells.CountZ);
            z1 = Cell((max.z + reach - cells.Origin.z) / cells.Side, cells.CountZ);
            double farthest = 0.5 * cells.Side * (Math.Abs(triangle.NormalX) + Math.Abs(triangle.NormalY) + Math.Abs(triangle.NormalZ)) +
                reach + slack;
            double a = triangle.Height(end.A), b = triangle.Height(end.B), c = triangle.Height(end.C);
            lowest = Math.Min(0.0, Math.Min(a, Math.Min(b, c))) - farthest;
            highest = Math.Max(0.0, Math.Max(a, Math.Max(b, c))) + farthest;
            x = x0 - 1;
            y = y0;
            z = z0;
        }

        /// <summary>Number of the cell that the walk is at.</summary>
        public int Number => (z * cells.CountY + y) * cells.CountX + x;

        /// <summary>Goes on to the next cell.</summary>
        /// <returns>False when there is none.</returns>
        public bool Next()
        {
            do
            {
                if (++x > x1)
                {
                    x = x0;
                    if (++y > y1)
                    {
                        y = y0;
                        if (++z > z1) return false;
                    }
                }
            }
            while (!IsNearBox() || !IsInSlab());
            return true;
        }

        private bool IsNearBox()
        {
            double dx = Apart(cells.Origin.x, x, min.x, max.x), dy = Apart(cells.Origin.y, y, min.y, max.y),
                dz = Apart(cells.Origin.z, z, min.z, max.z);
            return dx * dx + dy * dy + dz * dz <= reachSquared;
        }

        // Of a cell and the box along an axis.
        private double Apart(double origin, int cell, double low, double high)
        {
            double begin = origin + cell * (double)cells.Side;
            return Math.Max(0.0, Math.Max(low - begin - cells.Side, begin - high));
        }

        // A needle's normal is zero: its box decides.
        private bool IsInSlab()
        {
            double dx = cells.Origin.x + (x + 0.5) * cells.Side - triangle.A.x;
            double dy = cells.Origin.y + (y + 0.5) * cells.Side - triangle.A.y;
            double dz = cells.Origin.z + (z + 0.5) * cells.Side - triangle.A.z;
            double height = dx * triangle.NormalX + dy * triangle.NormalY + dz * triangle.NormalZ;
            return height >= lowest && height <= highest;
        }

        private static int Cell(double coordinate, int count) => (int)Math.Min(Math.Max(Math.Floor(coordinate), 0.0), count - 1);
    }
}
