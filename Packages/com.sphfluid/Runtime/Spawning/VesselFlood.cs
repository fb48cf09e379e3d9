using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Where and how liquid gets out of a vessel.</summary>
    internal readonly struct VesselLeak
    {
        public VesselLeak(Vector3 position, float holdsTo)
        {
            Position = position;
            HoldsTo = holdsTo;
        }

        /// <summary>Place of the rim or the gap in simulation space [m].</summary>
        public Vector3 Position { get; }

        /// <summary>Level over the seed up to which the vessel holds [m]; zero or less: it has a gap below the seed.</summary>
        public float HoldsTo { get; }
    }

    /// <summary>
    /// Floods a vessel from a seed, the lowest cell first, as water does, so that the path out of a vessel that leaks has the lowest
    /// possible highest point: its rim (R. Barnes et al., "Priority-Flood", Computers &amp; Geosciences 62, 2014).
    /// </summary>
    internal sealed class VesselFlood
    {
        // What a cell is, besides the number of the cell that the flood came from plus one.
        const int Dry = 0;
        const int Source = int.MaxValue;

        readonly VesselInput input;
        readonly VesselCells cells;
        readonly int[] cameFrom;
        readonly List<Stack<int>> waiting = new List<Stack<int>>();
        readonly float spacing, lowest;

        /// <summary>Floods.</summary>
        public VesselFlood(in VesselInput input, in SpawnLattice lattice)
        {
            this.input = input;
            spacing = lattice.Spacing;
            Bounds = new Bounds(input.Seed, Vector3.zero);
            Vector3 half = Vector3.Max(input.DomainSize * 0.5f - Vector3.one * (FluidSpawner.DomainMargin * spacing), Vector3.zero);
            Bounds space = new Bounds(Vector3.zero, 2f * half);
            if (!input.DomainHolds) space = Common(space, Surroundings());
            lowest = Height(space.center) - Vector3.Dot(Absolute(input.Up), space.extents) - 2f * spacing;
            cells = new VesselCells(lattice, space);
            IsTooFine = cells.Total > VesselCells.Most;
            if (IsTooFine) return;
            foreach (FluidObstacle solid in input.Colliders.Solids) cells.Add(solid.Mesh);
            cameFrom = new int[cells.Total];
            Flood(cells.At(input.Seed));
            if (Leak == null) return;
            Count = 0;
            Bounds = new Bounds(input.Seed, Vector3.zero);
        }

        /// <summary>Number of sites in the liquid, those too near to a wall included.</summary>
        public long Count { get; private set; }

        /// <summary>Bounds of those sites; of the seed when there are none.</summary>
        public Bounds Bounds { get; private set; }

        /// <summary>How the liquid gets out; null where it stays.</summary>
        public VesselLeak? Leak { get; private set; }

        /// <summary>Whether the block of cells is larger than can be flooded.</summary>
        public bool IsTooFine { get; }

        /// <summary>Whether the site at a point is the liquid's.</summary>
        public bool Contains(Vector3 point)
        {
            int cell = Count > 0 ? cells.At(point) : -1;
            return cell >= 0 && cameFrom[cell] != Dry;
        }

        void Flood(int seed)
        {
            if (seed < 0) return;
            Enter(seed, Source);
            for (int layer = 0; layer < waiting.Count && Leak == null; layer++)
                while (waiting[layer].Count > 0 && Leak == null)
                {
                    int cell = waiting[layer].Pop();
                    int lowestEntered = Spread(cell);
                    if (lowestEntered < layer)
                    {
                        layer = lowestEntered - 1;
                        break;
                    }
                }
        }

        // The lowest layer that the cell's neighbours wait in.
        int Spread(int cell)
        {
            int lowestEntered = int.MaxValue;
            for (int direction = 0; direction < 6; direction++)
            {
                int axis = direction >> 1;
                bool up = (direction & 1) != 0;
                if (cells.IsSeparated(cell, axis, up)) continue;
                int next = cells.Neighbour(cell, axis, up);
                if (next >= 0)
                {
                    if (cameFrom[next] == Dry) lowestEntered = Math.Min(lowestEntered, Enter(next, cell + 1));
                }
                else if (!input.DomainHolds)
                {
                    Vector3 beyond = cells.Site(cell);
                    beyond[axis] += up ? spacing : -spacing;
                    if (Height(beyond) >= input.Level) continue;
                    Leak = FindLeak(cell);
                    break;
                }
            }
            return lowestEntered;
        }

        // A site too near to a wall is the liquid's, so that it is counted as left out, but the flood does not go on from it: sites in a
        // wall may have no clear side.
        int Enter(int cell, int from)
        {
            Vector3 site = cells.Site(cell);
            float height = Height(site);
            if (height >= input.Level) return int.MaxValue;
            cameFrom[cell] = from;
            if (Count++ == 0) Bounds = new Bounds(site, Vector3.one * spacing);
            else Bounds = Enclosing(Bounds, new Bounds(site, Vector3.one * spacing));
            if (input.Colliders.FindCovering(site, input.Clearance) >= 0) return int.MaxValue;
            int layer = Math.Max((int)((height - lowest) / spacing), 0);
            while (waiting.Count <= layer) waiting.Add(new Stack<int>());
            waiting[layer].Push(cell);
            return layer;
        }

        VesselLeak FindLeak(int cell)
        {
            int highest = cell, contact = -1;
            for (int at = cell; ; at = cameFrom[at] - 1)
            {
                if (Height(cells.Site(at)) > Height(cells.Site(highest))) highest = at;
                if (contact < 0 && TouchesWall(at)) contact = at;
                if (cameFrom[at] == Source) break;
            }
            float rim = Height(cells.Site(highest));
            bool over = rim > spacing;
            return new VesselLeak(cells.Site(over || contact < 0 ? highest : contact), over ? rim : 0f);
        }

        bool TouchesWall(int cell)
        {
            for (int direction = 0; direction < 6; direction++)
                if (cells.IsSeparated(cell, direction >> 1, (direction & 1) != 0)) return true;
            return false;
        }

        float Height(Vector3 point) => Vector3.Dot(input.Up, point - input.Seed);

        // A cell round the colliders: liquid that comes there is out.
        Bounds Surroundings()
        {
            var bounds = new Bounds(input.Seed, Vector3.zero);
            foreach (FluidObstacle solid in input.Colliders.Solids) bounds = Enclosing(bounds, solid.Mesh.Bounds);
            bounds.Expand(2f * spacing);
            return bounds;
        }

        static Bounds Enclosing(Bounds a, Bounds b)
        {
            a.Encapsulate(b);
            return a;
        }

        static Bounds Common(Bounds a, Bounds b)
        {
            Vector3 min = Vector3.Max(a.min, b.min);
            var common = new Bounds();
            common.SetMinMax(min, Vector3.Max(min, Vector3.Min(a.max, b.max)));
            return common;
        }

        static Vector3 Absolute(Vector3 v) => new Vector3(Mathf.Abs(v.x), Mathf.Abs(v.y), Mathf.Abs(v.z));
    }
}
