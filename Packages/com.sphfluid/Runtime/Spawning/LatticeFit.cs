using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Lays a request's lattice so that the first box with faces along the domain's axes has its outer layers half a spacing inside
    /// its faces; without such a box, the first sphere or mesh in its bounds; else it starts at the domain's corner. No layer is nearer
    /// than half a spacing to a wall of the domain at which that shape stands: one that is starts with a push.
    /// </summary>
    internal static class LatticeFit
    {
        private const float AlignmentTolerance = 1e-4f, WallTolerance = 1e-3f; // of a spacing

        /// <summary>The lattice of a request.</summary>
        public static SpawnLattice For(SpawnRequest request)
        {
            LiquidShape first = null;
            foreach (LiquidShape shape in request.Shapes)
            {
                if (shape is LiquidVessel || !IsAligned(shape.Frame)) continue;
                if (first == null || shape is LiquidBox) first = shape;
                if (shape is LiquidBox) break;
            }
            return new SpawnLattice(first == null ? request.DomainSize * -0.5f : Anchor(first.Bounds, request), request.Spacing);
        }

        /// <summary>The lattice of a request, with its shapes fitted to it.</summary>
        public static SpawnLattice Fitted(SpawnRequest request)
        {
            SpawnLattice lattice = For(request);
            foreach (LiquidShape shape in request.Shapes) shape.Fit(lattice);
            return lattice;
        }

        private static Vector3 Anchor(Bounds bounds, SpawnRequest request)
        {
            Vector3 anchor = bounds.min;
            for (int axis = 0; axis < 3; axis++)
            {
                float wall = 0.5f * request.DomainSize[axis], tolerance = WallTolerance * request.Spacing;
                bool low = HasWall(request, 2 * axis) && bounds.min[axis] <= tolerance - wall,
                    high = HasWall(request, 2 * axis + 1) && bounds.max[axis] >= wall - tolerance;
                anchor[axis] = (float)Anchor(low ? -wall : bounds.min[axis], high ? wall : bounds.max[axis], low, high, request.Spacing);
            }
            return anchor;
        }

        // A box 1.04 m wide at dx = 0.1 m holds 10 layers; the 0.04 m left over are shared by both faces, or lie at the one that is no
        // wall. One of 1.06 m holds 11, whose centres are in it, but only 10 between two walls.
        private static double Anchor(double low, double high, bool lowWall, bool highWall, double spacing)
        {
            double fit = (high - low) / spacing;
            double layers = Math.Max(1.0, lowWall && highWall ? Math.Floor(fit + WallTolerance) : Math.Round(fit));
            double left = high - low - layers * spacing;
            return low + (lowWall == highWall ? 0.5 * left : lowWall ? 0.0 : left);
        }

        private static bool HasWall(SpawnRequest request, int face) => (request.Walls & (FluidFaces)(1 << face)) != 0;

        /// <summary>Whether a frame is along the axes.</summary>
        public static bool IsAligned(Matrix4x4 m)
        {
            for (int column = 0; column < 3; column++)
            {
                Vector4 c = m.GetColumn(column);
                float x = Mathf.Abs(c.x), y = Mathf.Abs(c.y), z = Mathf.Abs(c.z);
                float largest = Mathf.Max(x, Mathf.Max(y, z));
                if (x + y + z - largest > AlignmentTolerance * largest) return false;
            }
            return true;
        }
    }
}
