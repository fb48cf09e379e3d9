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
        private const int Dry = 0;
        private const int Source = int.MaxValue;

        // Of the spacing: a wall that is farther pushes no particle.
        private const float TouchingWalls = 0.499f;

        // Of the spacing: a site so near is on a wall.
        private const float OnWall = 0.02f;

        // Of the spacing: no two particles are nearer.
        private const float LeastDistance = 0.5f;

        private const int MostPushes = 6;

        private readonly VesselInput input;
        private readonly VesselCells cells;
        private readonly int[] cameFrom;
        private readonly List<Stack<int>> waiting = new List<Stack<int>>();
        private readonly float spacing, lowest;

        /// <summary>Floods.</summary>
        public VesselFlood(in VesselInput input, in SpawnLattice lattice)
        {
            this.input = input;
            spacing = lattice.Spacing;
            Bounds = new Bounds(input.Seed, Vector3.zero);
            var space = new Bounds(Vector3.zero, input.DomainSize);
            if (!input.DomainHolds) space = Common(space, Surroundings());
            lowest = Height(space.center) - Vector3.Dot(Absolute(input.Up), space.extents) - 2f * spacing;
            cells = new VesselCells(lattice, space);
            IsTooFine = cells.Total > VesselCells.Most;
            if (IsTooFine) return;
            foreach (FluidObstacle solid in input.Colliders.Solids) cells.Add(solid.Mesh);
            cameFrom = new int[cells.Total];
            Flood(cells.At(input.Seed));
            if (Leak == null)
            {
                Hollow = FindHollow();
                return;
            }
            Count = 0;
            Bounds = new Bounds(input.Seed, Vector3.zero);
        }

        /// <summary>Number of sites in the liquid, those at walls included.</summary>
        public long Count { get; private set; }

        /// <summary>Bounds of the hollow below the surface [m], from wall to wall.</summary>
        public Bounds Hollow { get; private set; }

        /// <summary>
        /// Where particles go: half a spacing inside the walls that cut their cells, and as many as the hollow's volume holds. Of more,
        /// those cut most are left out; where there are fewer, the layer above the surface has the rest.
        /// </summary>
        /// <param name="volume">The hollow's volume [m³].</param>
        public List<Vector3> Places(out double volume)
        {
            var kept = new List<Vector3>();
            var cut = new List<(float clear, uint order, Vector3 place)>();
            var spaced = new SpacedPoints(spacing);
            void Keep(Vector3 place)
            {
                kept.Add(place);
                spaced.Add(place);
            }
            void Add(int cell)
            {
                Vector3 place = Place(cell, out float clear);
                if (clear < 0.5f) cut.Add((clear, PcgHash.Hash((uint)cell), place));
                else Keep(place);
            }
            Vector3 steep = Absolute(input.Up);
            int upright = steep.x > steep.y && steep.x > steep.z ? 0 : steep.y > steep.z ? 1 : 2;
            bool up = input.Up[upright] > 0f;
            double held = 0.0;
            for (int cell = 0; cell < cameFrom.Length; cell++)
            {
                if (cameFrom[cell] == Dry) continue;
                held += 1.0 + Beyond(cell);
                Add(cell);
                if (!cells.IsSeparated(cell, upright, up) && cells.Neighbour(cell, upright, up) is int above && above >= 0 &&
                    Height(cells.Site(above)) >= input.Level)
                {
                    Add(above);
                }
            }
            foreach (FluidObstacle solid in input.Colliders.Solids) held += cells.Beyond(solid.Mesh, cell => cameFrom[cell] != Dry);
            volume = held * Math.Pow(spacing, 3);
            cut.Sort((a, b) => a.clear != b.clear ? b.clear.CompareTo(a.clear) : a.order.CompareTo(b.order));
            int most = (int)Math.Round(held);
            for (int i = 0; i < cut.Count && kept.Count < most; i++)
                if (!spaced.HasNear(cut[i].place, LeastDistance * spacing) &&
                    input.Colliders.FindCovering(cut[i].place, input.Clearance) < 0)
                {
                    Keep(cut[i].place);
                }
            return kept;
        }

        // Of the surface and of the domain's faces, as VesselCells.Beyond of triangles.
        private double Beyond(int cell)
        {
            double sum = 0.0;
            Vector3 site = cells.Site(cell);
            for (int direction = 0; direction < 6; direction++)
            {
                int axis = direction >> 1;
                bool up = (direction & 1) != 0;
                if (cells.IsSeparated(cell, axis, up)) continue;
                float rise = (up ? spacing : -spacing) * input.Up[axis], left = input.Level - Height(site);
                if (rise >= left) sum += input.Up[axis] * input.Up[axis] * (left / rise - 0.5);
                else if (Way(cell, axis, up) is float way && way < float.PositiveInfinity) sum += way - 0.5;
            }
            return sum;
        }

        // To what holds the liquid along an axis, in spacings; infinity where it goes on.
        private float Way(int cell, int axis, bool up)
        {
            if (cells.IsSeparated(cell, axis, up)) return cells.Clear(cell, axis, up);
            if (!input.DomainHolds || cells.Neighbour(cell, axis, up) >= 0) return float.PositiveInfinity;
            return (0.5f * input.DomainSize[axis] - (up ? 1f : -1f) * cells.Site(cell)[axis]) / spacing;
        }

        // Half a spacing inside walls; in a corner from one wall after the other. How far the site itself is from what its cell is cut by,
        // in spacings.
        private Vector3 Place(int cell, out float clear)
        {
            Vector3 place = cells.Site(cell);
            clear = Mathf.Min((input.Level - Height(place)) / spacing, 0.5f);
            for (int push = 0; push < MostPushes; push++)
            {
                if (!(input.Colliders.Nearest(place, TouchingWalls * spacing) is Vector3 wall)) break;
                Vector3 inward = (place - wall) / spacing;
                if (push == 0) clear = Mathf.Min(clear, inward.magnitude);
                place += (0.5f - inward.magnitude) * spacing * inward.normalized;
            }
            if (!input.DomainHolds) return place;
            Vector3 half = Vector3.Max(0.5f * (input.DomainSize - spacing * Vector3.one), Vector3.zero),
                held = Vector3.Max(Vector3.Min(place, half), -half);
            clear = Mathf.Min(clear, 0.5f - (place - held).magnitude / spacing);
            return held;
        }

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

        private Bounds FindHollow()
        {
            var walls = new Bounds(Bounds.center, Vector3.zero);
            for (int cell = 0; cell < cameFrom.Length; cell++)
            {
                if (cameFrom[cell] == Dry) continue;
                Vector3 site = cells.Site(cell);
                for (int direction = 0; direction < 6; direction++)
                {
                    int axis = direction >> 1;
                    bool up = (direction & 1) != 0;
                    float rise = (up ? spacing : -spacing) * input.Up[axis], left = input.Level - Height(site), way = Way(cell, axis, up);
                    if (float.IsPositiveInfinity(way)) way = rise >= left ? left / rise : 0f;
                    Vector3 reached = site;
                    reached[axis] += (up ? way : -way) * spacing;
                    walls.Encapsulate(reached);
                }
            }
            return walls;
        }

        private void Flood(int seed)
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
        private int Spread(int cell)
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

        // A site on a wall is the liquid's, but the flood does not go on from it: it may have no clear side.
        private int Enter(int cell, int from)
        {
            Vector3 site = cells.Site(cell);
            float height = Height(site);
            if (height >= input.Level) return int.MaxValue;
            cameFrom[cell] = from;
            if (Count++ == 0) Bounds = new Bounds(site, Vector3.one * spacing);
            else Bounds = Enclosing(Bounds, new Bounds(site, Vector3.one * spacing));
            if (input.Colliders.FindCovering(site, OnWall * spacing) >= 0) return int.MaxValue;
            int layer = Math.Max((int)((height - lowest) / spacing), 0);
            while (waiting.Count <= layer) waiting.Add(new Stack<int>());
            waiting[layer].Push(cell);
            return layer;
        }

        private VesselLeak FindLeak(int cell)
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
            // another lattice's lowest site over the rim may be lower
            return new VesselLeak(cells.Site(over || contact < 0 ? highest : contact), over ? rim - spacing : 0f);
        }

        private bool TouchesWall(int cell)
        {
            for (int direction = 0; direction < 6; direction++)
                if (cells.IsSeparated(cell, direction >> 1, (direction & 1) != 0)) return true;
            return false;
        }

        private float Height(Vector3 point) => Vector3.Dot(input.Up, point - input.Seed);

        // A cell round the colliders: liquid that comes there is out.
        private Bounds Surroundings()
        {
            var bounds = new Bounds(input.Seed, Vector3.zero);
            foreach (FluidObstacle solid in input.Colliders.Solids) bounds = Enclosing(bounds, solid.Mesh.Bounds);
            bounds.Expand(2f * spacing);
            return bounds;
        }

        private static Bounds Enclosing(Bounds a, Bounds b)
        {
            a.Encapsulate(b);
            return a;
        }

        private static Bounds Common(Bounds a, Bounds b)
        {
            Vector3 min = Vector3.Max(a.min, b.min);
            var common = new Bounds();
            common.SetMinMax(min, Vector3.Max(min, Vector3.Min(a.max, b.max)));
            return common;
        }

        private static Vector3 Absolute(Vector3 v) => new Vector3(Mathf.Abs(v.x), Mathf.Abs(v.y), Mathf.Abs(v.z));
    }
}
