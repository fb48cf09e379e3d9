using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>A box of liquid: any affine image of a cube.</summary>
    internal sealed class LiquidBox : LiquidShape
    {
        /// <summary>Half-width by which a point on a face counts as inside the lower face and outside the upper one.</summary>
        private const float FaceTolerance = 1e-4f;

        private const double MostColumned = 1 << 28, MostMissed = 0.02;

        private readonly Matrix4x4 toUnit;
        private readonly FluidFaces walls;

        /// <summary>Box whose corners are the images of (±½, ±½, ±½).</summary>
        /// <param name="name">Name for messages.</param>
        /// <param name="unitToSimulation">Maps the unit cube centred on the origin to simulation space [m].</param>
        /// <param name="velocity">Initial velocity in simulation space [m/s].</param>
        /// <param name="walls">Walls of the domain at which it stands; only of a box whose axes are the domain's.</param>
        public LiquidBox(string name, Matrix4x4 unitToSimulation, Vector3 velocity, FluidFaces walls = 0)
            : base(name, unitToSimulation, velocity)
        {
            this.walls = walls;
            AffineMath.TryInvert(unitToSimulation, out toUnit);
        }

        /// <inheritdoc/>
        public override double Volume => Math.Abs(AffineMath.Determinant(Frame));

        /// <summary>Whether the point lies in the box; of two touching boxes only one holds a point of the shared face.</summary>
        public override bool Contains(Vector3 point)
        {
            Vector3 p = toUnit.MultiplyPoint3x4(point);
            return Inside(p.x) && Inside(p.y) && Inside(p.z);
        }

        /// <summary>
        /// A box along the lattice's axes goes by it where that holds its volume. Any other has columns along its own height, evenly
        /// filled: those of a box 10.5 spacings wide are 1.05 of one apart, and hold 11 or 12 particles. A box that no whole number of
        /// spacings fits between two walls has level layers, spread from wall to wall.
        /// </summary>
        public override void Fit(in SpawnLattice lattice)
        {
            Sites = null;
            float spacing = lattice.Spacing;
            double wanted = Volume / Math.Pow(spacing, 3);
            if (wanted > MostColumned) return;
            if (IsSpread(0, spacing) || IsSpread(1, spacing) || IsSpread(2, spacing))
            {
                Sites = Layers(wanted, spacing);
                return;
            }
            if (LatticeFit.IsAligned(Frame) &&
                (!IsWide(spacing) ||
                    Math.Abs(Layers(lattice, 0) * Layers(lattice, 1) * Layers(lattice, 2) - wanted) <= MostMissed * wanted))
            {
                return;
            }
            Sites = Columns(wanted, Across(0, spacing), Across(2, spacing));
        }

        private bool IsBetweenWalls(int axis) => ((int)walls >> (2 * axis)) % 4 == 3;

        private bool IsSpread(int axis, float spacing)
        {
            double fit = Frame.GetColumn(axis).magnitude / spacing;
            return IsBetweenWalls(axis) && Math.Abs(fit - Math.Round(fit)) > MostMissed;
        }

        // As high as their volume asks for; what a whole number of them misses lies evenly on the highest.
        private IEnumerable<Vector3> Layers(double wanted, float spacing)
        {
            int wide = Across(0, spacing), deep = Across(2, spacing), area = wide * deep;
            double layers = IsBetweenWalls(1) ? Across(1, spacing) : wanted / area;
            int whole = (int)Math.Round(layers);
            double owed = 0.5, rest = 0.0;
            if (Math.Abs(whole - layers) > MostMissed * layers) rest = layers - (whole = (int)layers);
            for (int j = 0; j <= whole; j++)
                for (int k = 0; k < deep; k++)
                    for (int i = 0; i < wide; i++)
                    {
                        owed += j < whole ? 1.0 : rest;
                        if (owed < 1.0) continue;
                        owed -= 1.0;
                        yield return Frame.MultiplyPoint3x4(
                            new Vector3((i + 0.5f) / wide, (float)((j + 0.5) / layers), (k + 0.5f) / deep) - 0.5f * Vector3.one);
                    }
        }

        private int Across(int axis, float spacing) => Mathf.Max(Mathf.RoundToInt(Frame.GetColumn(axis).magnitude / spacing), 1);

        private IEnumerable<Vector3> Columns(double wanted, int wide, int deep)
        {
            double owed = 0.5;
            for (int k = 0; k < deep; k++)
                for (int i = 0; i < wide; i++)
                {
                    owed += wanted / ((double)wide * deep);
                    int count = (int)owed;
                    owed -= count;
                    for (int j = 0; j < count; j++)
                    {
                        yield return Frame.MultiplyPoint3x4(new Vector3((i + 0.5f) / wide, (j + 0.5f) / count, (k + 0.5f) / deep) -
                            0.5f * Vector3.one);
                    }
                }
        }

        // Of a box along the lattice's axes.
        private double Layers(in SpawnLattice lattice, int axis)
        {
            Vector3 place = Bounds.center;
            int layers = 0;
            (long first, long last) = lattice.Range(axis, Bounds.min[axis], Bounds.max[axis]);
            for (long i = first; i <= last; i++)
            {
                place[axis] = lattice.Site(i, i, i)[axis];
                layers += Contains(place) ? 1 : 0;
            }
            return layers;
        }

        private static bool Inside(float u) => u >= -0.5f - FaceTolerance && u < 0.5f - FaceTolerance;
    }
}
