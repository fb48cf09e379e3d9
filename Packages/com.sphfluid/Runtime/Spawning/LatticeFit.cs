using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Lays a request's lattice so that the first box with faces along the domain's axes has its outer layers half a spacing inside
    /// its faces; without such a box, the first sphere or mesh in its bounds; else it starts at the domain's corner.
    /// </summary>
    internal static class LatticeFit
    {
        const float AlignmentTolerance = 1e-4f;

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
            return new SpawnLattice(first == null ? request.DomainSize * -0.5f : Anchor(first.Bounds, request.Spacing), request.Spacing);
        }

        /// <summary>The lattice of a request, with its shapes fitted to it.</summary>
        public static SpawnLattice Fitted(SpawnRequest request)
        {
            SpawnLattice lattice = For(request);
            foreach (LiquidShape shape in request.Shapes) shape.Fit(lattice);
            return lattice;
        }

        // A box 1.04 m wide at dx = 0.1 m holds 10 layers; the 0.04 m left over are shared by both faces.
        static Vector3 Anchor(Bounds bounds, float spacing)
        {
            Vector3 anchor = bounds.min;
            for (int axis = 0; axis < 3; axis++)
            {
                double layers = Math.Max(1.0, Math.Round(bounds.size[axis] / (double)spacing));
                anchor[axis] += (float)((bounds.size[axis] - layers * spacing) * 0.5);
            }
            return anchor;
        }

        static bool IsAligned(Matrix4x4 m)
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
