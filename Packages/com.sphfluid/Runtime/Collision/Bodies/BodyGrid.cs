using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Lists of triangles by cell: a cell has each triangle whose box and plane meet the cell inflated by the reach. A particle's own cell
    /// then has every triangle within that reach of it.
    /// </summary>
    internal sealed class BodyGrid
    {
        const long MostCells = 2 * 1024 * 1024;

        // What rounding may move a cell's border by.
        const double Slack = 1e-4;

        readonly List<uint> starts = new List<uint>();
        readonly List<uint> references = new List<uint>();

        /// <summary>Cells over the triangles' bounds, the reach added.</summary>
        /// <param name="triangles">All triangles of the buffer.</param>
        /// <param name="first">First of the body's.</param>
        /// <param name="count">Number of the body's.</param>
        /// <param name="reach">How far a cell looks [m].</param>
        /// <param name="within">Bounds beyond which no particle is; null for none.</param>
        public BodyGrid(IReadOnlyList<BodyTriangle> triangles, int first, int count, float reach, Bounds? within)
        {
            Vector3 min = Vector3.positiveInfinity, max = Vector3.negativeInfinity;
            for (int t = first; t < first + count; t++)
            {
                BodyTriangle tri = triangles[t];
                min = Vector3.Min(min, Vector3.Min(tri.A, Vector3.Min(tri.B, tri.C)));
                max = Vector3.Max(max, Vector3.Max(tri.A, Vector3.Max(tri.B, tri.C)));
            }
            BoundsMin = min;
            BoundsMax = max;
            Vector3 low = min - reach * Vector3.one, high = max + reach * Vector3.one;
            if (within.HasValue)
            {
                Vector3 margin = 0.01f * reach * Vector3.one; // a particle on a face is in a cell
                low = Vector3.Max(low, within.Value.min - margin);
                high = Vector3.Min(high, within.Value.max + margin);
            }
            Vector3 size = Vector3.Max(high - low, Vector3.zero);
            Side = reach;
            while (CellsOf(size) > MostCells) Side *= 1.26f;
            Origin = low;
            Counts = new Vector3Int(Math.Max(1, Mathf.CeilToInt(size.x / Side)), Math.Max(1, Mathf.CeilToInt(size.y / Side)), Math.Max(1, Mathf.CeilToInt(size.z / Side)));
            Fill(triangles, first, count, reach);
        }

        public Vector3 Origin { get; }
        public float Side { get; }
        public Vector3Int Counts { get; }
        public Vector3 BoundsMin { get; }
        public Vector3 BoundsMax { get; }

        /// <summary>Ranges of the cells in <see cref="References"/>: one entry more than cells.</summary>
        public IReadOnlyList<uint> Starts => starts;

        /// <summary>Indices of triangles, cell by cell.</summary>
        public IReadOnlyList<uint> References => references;

        double CellsOf(Vector3 size) => Math.Ceiling(size.x / Side) * Math.Ceiling(size.y / Side) * Math.Ceiling(size.z / Side);

        void Fill(IReadOnlyList<BodyTriangle> triangles, int first, int count, float reach)
        {
            int cells = Counts.x * Counts.y * Counts.z;
            var counts = new int[cells + 1];
            for (int t = first; t < first + count; t++) Visit(triangles[t], reach, cell => counts[cell + 1]++);
            for (int cell = 0; cell < cells; cell++) counts[cell + 1] += counts[cell];
            foreach (int start in counts) starts.Add((uint)start);
            var next = new int[cells];
            Array.Copy(counts, next, cells);
            var lists = new uint[counts[cells]];
            for (int t = first; t < first + count; t++)
            {
                int index = t;
                Visit(triangles[t], reach, cell => lists[next[cell]++] = (uint)index);
            }
            references.AddRange(lists);
        }

        void Visit(in BodyTriangle tri, float reach, Action<int> found)
        {
            double inflate = reach * (1.0 + Slack);
            Vector3 min = Vector3.Min(tri.A, Vector3.Min(tri.B, tri.C)), max = Vector3.Max(tri.A, Vector3.Max(tri.B, tri.C));
            int x0 = Cell(min.x - inflate, 0), x1 = Cell(max.x + inflate, 0);
            int y0 = Cell(min.y - inflate, 1), y1 = Cell(max.y + inflate, 1);
            int z0 = Cell(min.z - inflate, 2), z1 = Cell(max.z + inflate, 2);
            double half = (0.5 * Side + inflate) * (Math.Abs(tri.NormalX) + Math.Abs(tri.NormalY) + Math.Abs(tri.NormalZ)) + Slack * Side;
            for (int z = z0; z <= z1; z++)
            for (int y = y0; y <= y1; y++)
            for (int x = x0; x <= x1; x++)
            {
                double cx = Origin.x + (x + 0.5) * Side - tri.A.x, cy = Origin.y + (y + 0.5) * Side - tri.A.y, cz = Origin.z + (z + 0.5) * Side - tri.A.z;
                // A needle's normal is zero: its box decides.
                if (Math.Abs(cx * tri.NormalX + cy * tri.NormalY + cz * tri.NormalZ) <= half) found((z * Counts.y + y) * Counts.x + x);
            }
        }

        int Cell(double coordinate, int axis) =>
            (int)Math.Min(Math.Max(Math.Floor((coordinate - Origin[axis]) / Side), 0.0), Counts[axis] - 1);
    }
}
