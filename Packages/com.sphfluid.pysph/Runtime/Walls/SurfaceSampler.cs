using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Triangles as layers of particles on the side away from the liquid. Layer k of a closed mesh lies (k + ½) dx behind the surface; an
    /// open one has its first layer on the surface. Sites of a lattice over each triangle are tried first, then a finer lattice where they
    /// left gaps, and no two particles are nearer than 0.83 dx. Solids thinner than dx have what fits. Every place of the surface has a
    /// particle within dx.
    /// </summary>
    internal sealed class SurfaceSampler
    {
        // Over the spacing: a greedy choice of points at least 0.83 dx apart has about one point a dx², as a lattice has.
        private const float LeastDistance = 0.83f;

        // Over the spacing: with places a quarter of a spacing apart that are looked at, none between them is farther than a spacing.
        private const float CoverDistance = 0.9f;

        // Of a layer's depth: as far as it must be from all other triangles.
        private const float DepthTolerance = 0.98f;

        // Over the spacing: from liquid that is there already, of meshes without an inside.
        private const float LiquidClearance = 0.7f;

        private const int FineSteps = 4;

        private readonly TriangleMesh mesh;
        private readonly float spacing;
        private readonly SpacedPoints taken;
        private readonly SpacedPoints liquid; // null: not asked for
        private readonly Bounds within;
        private readonly Vector3 anchor;
        private readonly bool looksInward;
        private readonly List<Vector3> points = new List<Vector3>();

        private SurfaceSampler(TriangleMesh mesh, float spacing, Bounds within, SpacedPoints taken, SpacedPoints liquid)
        {
            this.mesh = mesh;
            this.spacing = spacing;
            this.within = within;
            this.taken = taken;
            this.liquid = mesh.IsClosed ? null : liquid;
            looksInward = mesh.IsClosed && LiquidMesh.SignedVolume(mesh) < 0.0;
            anchor = Anchor(mesh.Bounds, spacing);
        }

        /// <summary>Samples a mesh.</summary>
        /// <param name="mesh">The triangles [m].</param>
        /// <param name="spacing">Particle spacing dx [m].</param>
        /// <param name="layers">Layers, 1 or more.</param>
        /// <param name="within">Where particles are wanted [m].</param>
        /// <param name="taken">Particles of walls that are there already, for reaches of dx; receives those of the mesh.</param>
        /// <param name="liquid">Particles of the liquid, for reaches of dx: meshes without an inside leave it its place. Null: there are
        /// none.</param>
        /// <returns>Positions [m].</returns>
        public static List<Vector3> Sample(TriangleMesh mesh, float spacing, int layers, Bounds within, SpacedPoints taken,
            SpacedPoints liquid = null)
        {
            var sampler = new SurfaceSampler(mesh, spacing, within, taken, liquid);
            for (int layer = 0; layer < layers; layer++) sampler.AddLayer(layer);
            return sampler.points;
        }

        private void AddLayer(int layer)
        {
            float depth = mesh.IsClosed ? (layer + 0.5f) * spacing : layer * spacing;
            Walk(1, (place, normal) => TryAdd(place - depth * normal, depth));
            Walk(FineSteps, (place, normal) => TryAdd(place - depth * normal, depth));
            if (layer == 0) Walk(FineSteps, Cover);
        }

        // What no particle is near: a thin part, or an edge.
        private void Cover(Vector3 place, Vector3 normal)
        {
            if (taken.HasNear(place, CoverDistance * spacing)) return;
            Vector3 behind = place - 0.25f * spacing * normal;
            if (mesh.IsClosed && IsSolid(behind) && !taken.HasNear(behind, LeastDistance * spacing)) place = behind;
            if (within.Contains(place)) Add(place);
        }

        private void TryAdd(Vector3 place, float depth)
        {
            if (!within.Contains(place) || taken.HasNear(place, LeastDistance * spacing)) return;
            if (mesh.IsClosed && !IsSolid(place) || depth > 0f && mesh.IsNear(place, DepthTolerance * depth)) return;
            if (liquid == null || depth == 0f || !liquid.HasNear(place, LiquidClearance * spacing)) Add(place);
        }

        private void Add(Vector3 place)
        {
            points.Add(place);
            taken.Add(place);
        }

        // Round a vessel whose faces look inward all is solid that they do not enclose.
        private bool IsSolid(Vector3 place) => looksInward ? mesh.Winding(place) >= 0 : mesh.Winding(place) > 0;

        // The lattice is that of the plane that the triangle is flattest to, so it is stretched by √3 at most; the middle stands for
        // triangles that no site is in.
        private void Walk(int steps, Action<Vector3, Vector3> visit)
        {
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out Vector3 a, out Vector3 b, out Vector3 c);
                if (TriangleMesh.IsDegenerate(a, b, c)) continue;
                Vector3 normal = Vector3.Cross(b - a, c - a).normalized;
                int across = Across(normal);
                int first = (across + 1) % 3, second = (across + 2) % 3;
                double step = spacing / (double)steps;
                (long i0, long i1) = Range(first, step, a, b, c);
                (long j0, long j1) = Range(second, step, a, b, c);
                for (long j = j0; j <= j1; j++)
                    for (long i = i0; i <= i1; i++)
                    {
                        double u = anchor[first] + (i + 0.5) * step, v = anchor[second] + (j + 0.5) * step;
                        if (Holds(u, v, first, second, a, b, c)) visit(OnPlane(u, v, first, second, across, a, normal), normal);
                    }
                if (steps > 1 && within.Contains((a + b + c) / 3f)) visit((a + b + c) / 3f, normal);
            }
        }

        private (long first, long last) Range(int axis, double step, Vector3 a, Vector3 b, Vector3 c)
        {
            double low = Math.Max(Math.Min(a[axis], Math.Min(b[axis], c[axis])), within.min[axis]);
            double high = Math.Min(Math.Max(a[axis], Math.Max(b[axis], c[axis])), within.max[axis]);
            return ((long)Math.Ceiling((low - anchor[axis]) / step - 0.5 - 1e-4),
                (long)Math.Floor((high - anchor[axis]) / step - 0.5 + 1e-4));
        }

        private static bool Holds(double u, double v, int first, int second, Vector3 a, Vector3 b, Vector3 c)
        {
            double ab = Side(u, v, a[first], a[second], b[first], b[second]);
            double bc = Side(u, v, b[first], b[second], c[first], c[second]);
            double ca = Side(u, v, c[first], c[second], a[first], a[second]);
            return ab >= 0.0 && bc >= 0.0 && ca >= 0.0 || ab <= 0.0 && bc <= 0.0 && ca <= 0.0;
        }

        private static double Side(double u, double v, double fromU, double fromV, double toU, double toV) =>
            (toU - fromU) * (v - fromV) - (toV - fromV) * (u - fromU);

        private static Vector3 OnPlane(double u, double v, int first, int second, int across, Vector3 a, Vector3 normal)
        {
            Vector3 place = default;
            place[first] = (float)u;
            place[second] = (float)v;
            place[across] = (float)(a[across] - (normal[first] * (u - a[first]) + normal[second] * (v - a[second])) / normal[across]);
            return place;
        }

        private static int Across(Vector3 normal)
        {
            float x = Mathf.Abs(normal.x), y = Mathf.Abs(normal.y), z = Mathf.Abs(normal.z);
            return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
        }

        // A box 1.04 m wide at dx = 0.1 m has 10 sites; the 0.04 m left over are shared by both ends.
        private static Vector3 Anchor(Bounds bounds, float spacing)
        {
            Vector3 anchor = bounds.min;
            for (int axis = 0; axis < 3; axis++)
            {
                anchor[axis] +=
                    (float)(0.5 * (bounds.size[axis] - Math.Max(1.0, Math.Round(bounds.size[axis] / (double)spacing)) * spacing));
            }
            return anchor;
        }
    }
}
