using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A block of lattice sites and where triangles separate neighbours. The lines between sites are intersected with the triangles
    /// by a test that never slips between two of them (<see cref="TriangleMath.Side"/>).
    /// </summary>
    internal sealed class VesselCells
    {
        /// <summary>Most sites of a block.</summary>
        public const long Most = 1 << 25;

        private readonly SpawnLattice lattice;
        private readonly long[] first = new long[3];
        private readonly int[] counts = new int[3];
        private readonly int[] strides = new int[3];
        // of an axis, above each site: the first and the last hit, 1 + 254 times its share of the way; 0: none
        private readonly byte[][] lowest = new byte[3][], highest = new byte[3][];

        /// <summary>The sites within bounds and, below them, a layer that only records what separates it from them.</summary>
        public VesselCells(in SpawnLattice lattice, Bounds bounds)
        {
            this.lattice = lattice;
            Total = 1;
            for (int axis = 0; axis < 3; axis++)
            {
                (long low, long high) = lattice.Range(axis, bounds.min[axis], bounds.max[axis]);
                first[axis] = low - 1;
                long count = Math.Max(high - low + 2, 1);
                strides[axis] = (int)Math.Min(Total, Most);
                Total = Math.Min(Total * count, Most + 1);
                counts[axis] = (int)Math.Min(count, Most);
            }
            if (Total > Most) return;
            for (int axis = 0; axis < 3; axis++) (lowest[axis], highest[axis]) = (new byte[Total], new byte[Total]);
        }

        /// <summary>Number of cells, the layer below included; above <see cref="Most"/> the block cannot be used.</summary>
        public long Total { get; }

        /// <summary>Cell whose site is nearest to a point; −1 outside the block.</summary>
        public int At(Vector3 point)
        {
            int cell = 0;
            for (int axis = 0; axis < 3; axis++)
            {
                double index = Math.Round((point[axis] - (double)lattice.Origin[axis]) / lattice.Spacing - 0.5) - first[axis];
                if (!(index >= 1.0 && index < counts[axis])) return -1;
                cell += (int)index * strides[axis];
            }
            return cell;
        }

        /// <summary>Site of a cell [m].</summary>
        public Vector3 Site(int cell) => lattice.Site(first[0] + Index(cell, 0), first[1] + Index(cell, 1), first[2] + Index(cell, 2));

        /// <summary>Neighbour of a cell.</summary>
        /// <param name="cell">The cell.</param>
        /// <param name="axis">0, 1, 2 for x, y, z.</param>
        /// <param name="up">Whether the neighbour is the one towards the axis.</param>
        /// <returns>The neighbour; −1 outside the block.</returns>
        public int Neighbour(int cell, int axis, bool up)
        {
            int index = Index(cell, axis);
            if (up) return index + 1 < counts[axis] ? cell + strides[axis] : -1;
            return index > 1 ? cell - strides[axis] : -1;
        }

        /// <summary>Whether a triangle lies between a cell and its neighbour, also one outside the block.</summary>
        public bool IsSeparated(int cell, int axis, bool up) => lowest[axis][up ? cell : cell - strides[axis]] != 0;

        /// <summary>Share of the way to a neighbour at which the first triangle is, where one separates them.</summary>
        public float Clear(int cell, int axis, bool up) => up ? Share(lowest[axis][cell]) : 1f - Share(highest[axis][cell - strides[axis]]);

        /// <summary>Marks what triangles separate.</summary>
        public void Add(TriangleMesh mesh) => Visit(mesh, (below, axis, hit, weight) =>
        {
            ref byte low = ref lowest[axis][below], high = ref highest[axis][below];
            if (low == 0 || hit < low) low = hit;
            if (hit > high) high = hit;
        });

        /// <summary>
        /// What the cells of liquid reach beyond half-way to the triangles of a mesh, in cells: counted along each axis, by the square of
        /// the normal along it, which of a plane sum to one.
        /// </summary>
        public double Beyond(TriangleMesh mesh, Func<int, bool> isLiquid)
        {
            double sum = 0.0;
            Visit(mesh, (below, axis, hit, weight) =>
            {
                if (hit == lowest[axis][below] && Index(below, axis) > 0 && isLiquid(below)) sum += weight * (Share(hit) - 0.5);
                int above = below + strides[axis];
                if (hit == highest[axis][below] && Index(below, axis) + 1 < counts[axis] && isLiquid(above))
                {
                    sum += weight * (0.5 - Share(hit));
                }
            });
            return sum;
        }

        private static float Share(byte hit) => (hit - 1) / 254f;

        private void Visit(TriangleMesh mesh, Action<int, int, byte, double> visit)
        {
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out Vector3 a, out Vector3 b, out Vector3 c);
                if (!AffineMath.IsFinite(a + b + c)) continue;
                Vector3 normal = Vector3.Cross(b - a, c - a).normalized;
                for (int axis = 0; axis < 3; axis++) Visit(axis, a, b, c, normal[axis] * normal[axis], visit);
            }
        }

        private int Index(int cell, int axis) => cell / strides[axis] % counts[axis];

        private void Visit(int axis, Vector3 a, Vector3 b, Vector3 c, double weight, Action<int, int, byte, double> visit)
        {
            int second = (axis + 1) % 3, third = (axis + 2) % 3;
            Vector3 min = Vector3.Min(a, Vector3.Min(b, c)), max = Vector3.Max(a, Vector3.Max(b, c));
            Vector3 u = Turned(a, axis), v = Turned(b, axis), w = Turned(c, axis);
            (int j0, int j1) = Clamped(second, min[second], max[second]);
            (int k0, int k1) = Clamped(third, min[third], max[third]);
            for (int k = k0; k <= k1; k++)
                for (int j = j0; j <= j1; j++)
                {
                    var line = new Vector3(0f, Coordinate(second, j), Coordinate(third, k));
                    if (TriangleMath.LineCrossing(line, u, v, w, out double hit) == 0) continue;
                    double place = (hit - lattice.Origin[axis]) / lattice.Spacing - 0.5 - first[axis], below = Math.Floor(place);
                    if (below >= 0.0 && below < counts[axis])
                    {
                        visit((int)below * strides[axis] + j * strides[second] + k * strides[third], axis,
                            (byte)(1.5 + 254.0 * (place - below)), weight);
                    }
                }
        }

        // The axis as x, the others behind it in their cyclic order.
        private static Vector3 Turned(Vector3 p, int axis) => new Vector3(p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]);

        private float Coordinate(int axis, int index) => (float)(lattice.Origin[axis] + (first[axis] + index + 0.5) * lattice.Spacing);

        private (int low, int high) Clamped(int axis, float min, float max)
        {
            (long low, long high) = lattice.Range(axis, min, max);
            return ((int)Math.Max(low - first[axis], 0), (int)Math.Min(high - first[axis], counts[axis] - 1));
        }
    }
}
