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

        /// <summary>Cells of at least the reach over a box, more than which there are only <paramref name="most"/>.</summary>
        public static BodyCells Over(Vector3 low, Vector3 high, float reach, long most)
        {
            Vector3 size = Vector3.Max(high - low, Vector3.zero);
            float side = reach;
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

    /// <summary>Goes through the cells that list a triangle: those whose cube, inflated by the reach, intersects its box and its plane.</summary>
    internal struct BodyCellWalk
    {
        readonly BodyCells cells;
        readonly BodyTriangle triangle;
        readonly double farthest; // of a cell's middle from the plane
        readonly int x0, x1, y0, y1, z1;
        int x, y, z;

        public BodyCellWalk(in BodyCells cells, in BodyTriangle triangle)
        {
            this.cells = cells;
            this.triangle = triangle;
            double inflate = cells.Reach * (1.0 + BodyCells.Slack);
            Vector3 min = Vector3.Min(triangle.A, Vector3.Min(triangle.B, triangle.C)), max = Vector3.Max(triangle.A, Vector3.Max(triangle.B, triangle.C));
            x0 = Cell((min.x - inflate - cells.Origin.x) / cells.Side, cells.CountX);
            x1 = Cell((max.x + inflate - cells.Origin.x) / cells.Side, cells.CountX);
            y0 = Cell((min.y - inflate - cells.Origin.y) / cells.Side, cells.CountY);
            y1 = Cell((max.y + inflate - cells.Origin.y) / cells.Side, cells.CountY);
            int z0 = Cell((min.z - inflate - cells.Origin.z) / cells.Side, cells.CountZ);
            z1 = Cell((max.z + inflate - cells.Origin.z) / cells.Side, cells.CountZ);
            farthest = (0.5 * cells.Side + inflate) * (Math.Abs(triangle.NormalX) + Math.Abs(triangle.NormalY) + Math.Abs(triangle.NormalZ)) + BodyCells.Slack * cells.Side;
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
            while (!IntersectsPlane());
            return true;
        }

        // A needle's normal is zero: its box decides.
        bool IntersectsPlane()
        {
            double dx = cells.Origin.x + (x + 0.5) * cells.Side - triangle.A.x;
            double dy = cells.Origin.y + (y + 0.5) * cells.Side - triangle.A.y;
            double dz = cells.Origin.z + (z + 0.5) * cells.Side - triangle.A.z;
            return Math.Abs(dx * triangle.NormalX + dy * triangle.NormalY + dz * triangle.NormalZ) <= farthest;
        }

        static int Cell(double coordinate, int count) => (int)Math.Min(Math.Max(Math.Floor(coordinate), 0.0), count - 1);
    }
}
