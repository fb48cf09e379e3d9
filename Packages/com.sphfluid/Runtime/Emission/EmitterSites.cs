using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// The places of one layer of particles across a nozzle: a square lattice of the particle spacing, in number not less than the nozzle's
    /// area asks for. Layers follow at that distance, a spacing or a little more, at which liquid of the rest density leaves with the
    /// nozzle's area.
    /// </summary>
    internal sealed class EmitterSites
    {
        // A nozzle of more is a mistake in its size.
        public const int Most = 1 << 16;

        private EmitterSites(Vector3[] places, double layerDistance)
        {
            Places = places;
            LayerDistance = layerDistance;
        }

        /// <summary>The places in the emitter's space [m]: across its forward axis, and of a mesh also ahead of it.</summary>
        public Vector3[] Places { get; }

        /// <summary>Distance of layers [m]: dx (n dx²)/A.</summary>
        public double LayerDistance { get; }

        /// <summary>
        /// The places of an emitter: of four lattices, with a place or the corner of a cell in the middle along each axis, the one that
        /// fits best.
        /// </summary>
        /// <exception cref="ArgumentException">The nozzle needs more than <see cref="Most"/>.</exception>
        public static EmitterSites For(in EmitterSpec emitter, float spacing)
        {
            if (emitter.Shape == FluidEmitterShape.Mesh) return new EmitterSites(EmitterOutline.Create(emitter, spacing).Places, spacing);
            double area = emitter.Area(spacing), cell = (double)spacing * spacing;
            double needed = Math.Max(1.0, Math.Ceiling(area / cell - 1e-3));
            if (!(needed <= Most))
            {
                throw new ArgumentException(
                    FormattableString.Invariant($"The nozzle of '{emitter.Name}' needs {needed:0} particles a layer; {Most} are allowed."));
            }
            Vector2[] best = null;
            double bestDepth = double.NegativeInfinity;
            for (int offset = 0; offset < 4; offset++)
            {
                Vector2[] places =
                    Deepest(emitter, spacing, new Vector2(0.5f * (offset & 1), 0.5f * (offset >> 1)), (int)needed, out double depth);
                if (!(depth > bestDepth + 1e-6 * spacing)) continue;
                best = places;
                bestDepth = depth;
            }
            return new EmitterSites(Array.ConvertAll(best, p => (Vector3)p), spacing * (needed * cell / area));
        }

        private static Vector2[] Deepest(in EmitterSpec emitter, float spacing, Vector2 offset, int count, out double least)
        {
            var found = new List<(double depth, Vector2 place)>();
            Vector2 half = 0.5f * (emitter.Shape == FluidEmitterShape.Line ? new Vector2(emitter.Size.x, spacing) : emitter.Size);
            int reachX = (int)Math.Ceiling(half.x / spacing) + 1, reachY = (int)Math.Ceiling(half.y / spacing) + 1;
            for (int y = -reachY; y <= reachY; y++)
                for (int x = -reachX; x <= reachX; x++)
                {
                    Vector2 place = spacing * new Vector2(x + offset.x, y + offset.y);
                    found.Add((Depth(emitter.Shape, half, place), place));
                }
            // Stable, so that places at the same depth are taken in the order of the lattice.
            var order = new int[found.Count];
            for (int i = 0; i < order.Length; i++) order[i] = i;
            Array.Sort(order, (a, b) => Math.Abs(found[a].depth - found[b].depth) > 1e-9 ? found[b].depth.CompareTo(found[a].depth)
                : a.CompareTo(b));
            var places = new Vector2[count];
            for (int i = 0; i < count; i++) places[i] = found[order[i]].place;
            least = found[order[count - 1]].depth;
            return places;
        }

        // How far inside the outline, below zero outside [m]; along the shorter radius of an ellipse.
        private static double Depth(FluidEmitterShape shape, Vector2 half, Vector2 place)
        {
            if (shape != FluidEmitterShape.Disc) return Math.Min(half.x - Math.Abs(place.x), half.y - Math.Abs(place.y));
            double x = place.x / half.x, y = place.y / half.y;
            return (1.0 - Math.Sqrt(x * x + y * y)) * Math.Min(half.x, half.y);
        }
    }
}
