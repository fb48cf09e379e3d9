using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// What of a rectangle lies on a wall, and where that wall ends beside it: at an edge of its own, at another wall, or at a face of the
    /// domain.
    /// </summary>
    internal readonly struct WallCover
    {
        private const float Far = 1e9f;  // spacings
        private const float Side = 0.5f; // cosine: what looks less along the normal is another wall
        private const float Above = 0.25f, Strip = 0.02f; // spacings

        /// <summary>Area on the wall [m²].</summary>
        public readonly double Area;

        /// <summary>
        /// Distances from the centre to the wall's ends along −x, x, −y and y of the rectangle [m]; far where it has none within two
        /// spacings of the rectangle.
        /// </summary>
        public readonly Vector4 Ends;

        private WallCover(double area, Vector4 ends)
        {
            Area = area;
            Ends = ends;
        }

        /// <summary>Of a rectangle whose centre is on a wall; all of it, without ends, where there is no wall.</summary>
        public static WallCover Of(WallPatch patch, float depth, in FluidSolverSettings settings, IReadOnlyList<FluidObstacle> solids)
        {
            float spacing = settings.Spacing;
            Vector2 half = 0.5f * patch.Size;
            var size = new Vector4(half.x, half.x, half.y, half.y);
            Vector4 limits = size + 2f * spacing * Vector4.one; // a foot a spacing beside it, and what is spread about that
            Vector4 ends = Far * spacing * Vector4.one;
            var walls = new List<List<Vector3>>(); // corners in the rectangle's axes
            Matrix4x4 toPatch = Matrix4x4.TRS(patch.Centre, patch.Rotation, Vector3.one).inverse;
            AddFaces(settings, toPatch, depth, walls, ref ends);
            foreach (FluidObstacle solid in solids) AddMesh(solid.Mesh, toPatch, depth, limits, spacing, walls, ref ends);

            Vector4 seen = Vector4.Min(limits, ends);
            Vector4 own = Vector4.Min(size, ends);
            double area = Covered(walls, -own.x, own.y, -own.z, own.w);
            float strip = Strip * spacing;
            double tall = Covered(walls, -strip, strip, -seen.z, seen.w) / (2.0 * strip);
            double wide = Covered(walls, -seen.x, seen.y, -strip, strip) / (2.0 * strip);
            if (!(tall > strip && wide > strip)) return new WallCover(patch.RectangleArea, Far * spacing * Vector4.one);
            var along = new Vector4((float)(Covered(walls, -seen.x, 0f, -seen.z, seen.w) / tall),
                (float)(Covered(walls, 0f, seen.y, -seen.z, seen.w) / tall), (float)(Covered(walls, -seen.x, seen.y, -seen.z, 0f) / wide),
                (float)(Covered(walls, -seen.x, seen.y, 0f, seen.w) / wide));
            for (int side = 0; side < 4; side++)
            {
                if (along[side] < seen[side] - strip) ends[side] = Math.Max(along[side], strip);
                else if (ends[side] > limits[side]) ends[side] = Far * spacing;
            }
            return new WallCover(area, ends);
        }

        private static Vector3 Direction(int side) => (side % 2 == 0 ? -1f : 1f) * (side < 2 ? Vector3.right : Vector3.up);

        private static void AddFaces(in FluidSolverSettings settings, in Matrix4x4 toPatch, float depth, List<List<Vector3>> walls,
            ref Vector4 ends)
        {
            Vector3 half = 0.5f * settings.DomainSize, period = settings.PeriodLength;
            for (int face = 0; face < 6; face++)
            {
                int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
                if (period[axis] > 0f) continue;
                var middle = new Vector3();
                middle[axis] = face % 2 == 0 ? -half[axis] : half[axis];
                Vector3 along = new Vector3(), across = new Vector3();
                along[u] = half[u] + period[u];
                across[v] = half[v] + period[v];
                var corners = new[] { middle - along - across, middle + along - across, middle + along + across, middle - along + across };
                for (int i = 0; i < 4; i++) corners[i] = toPatch.MultiplyPoint3x4(corners[i]);
                Vector3 inward = toPatch.MultiplyVector(-middle).normalized;
                if (inward.z > Side && (settings.Boundaries.Open & (FluidFaces)(1 << face)) == 0) AddNear(corners, depth, walls);
                for (int side = 0; side < 4; side++) // the domain ends at an open face too
                {
                    float towards = -Vector3.Dot(inward, Direction(side));
                    float away = Vector3.Dot(inward, -toPatch.MultiplyPoint3x4(middle));
                    if (towards > Side && away > 0f) ends[side] = Math.Min(ends[side], away / towards);
                }
            }
        }

        private static void AddMesh(TriangleMesh mesh, in Matrix4x4 toPatch, float depth, Vector4 limits, float spacing,
            List<List<Vector3>> walls, ref Vector4 ends)
        {
            Vector3 centre = toPatch.inverse.MultiplyPoint3x4(Vector3.zero);
            float reach = new Vector2(Math.Max(limits.x, limits.y), Math.Max(limits.z, limits.w)).magnitude + depth;
            if (mesh.TriangleCount == 0 || mesh.Bounds.SqrDistance(centre) > reach * reach) return;
            var found = new List<(Vector3[] Corners, float Facing)>();
            float nearest = float.PositiveInfinity, sign = 0f;
            var from = new Vector3(0f, 0f, Above * spacing);
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out Vector3 a, out Vector3 b, out Vector3 c);
                (a, b, c) = (toPatch.MultiplyPoint3x4(a), toPatch.MultiplyPoint3x4(b), toPatch.MultiplyPoint3x4(c));
                Vector3 low = Vector3.Min(a, Vector3.Min(b, c)), high = Vector3.Max(a, Vector3.Max(b, c));
                bool isFar = low.x > limits.y || high.x < -limits.x || low.y > limits.w || high.y < -limits.z;
                if (isFar || low.z > reach || high.z < -reach) continue;
                float facing = Vector3.Cross(b - a, c - a).normalized.z;
                if (Math.Abs(facing) > Side)
                {
                    found.Add((new[] { a, b, c }, facing));
                    float distance = TriangleMath.ClosestPoint(Vector3.zero, a, b, c).magnitude;
                    if (distance < nearest) (nearest, sign) = (distance, facing);
                    continue;
                }
                for (int side = 0; side < 4; side++)
                {
                    bool meets = TriangleMath.LineCrosses(from, Direction(side), a, b, c, out float along);
                    if (meets && along > 0f) ends[side] = Math.Min(ends[side], along);
                }
            }
            foreach ((Vector3[] corners, float facing) in found)
                if (!mesh.IsClosed || facing > 0f == sign > 0f) AddNear(corners, depth, walls); // not the back of a thin plate
        }

        private static void AddNear(Vector3[] corners, float depth, List<List<Vector3>> walls)
        {
            List<Vector3> near = Cut(Cut(new List<Vector3>(corners), 2, -depth, 1f), 2, depth, -1f);
            if (near.Count > 2) walls.Add(near);
        }

        // Area of the walls over a range of x and y; where they overlap it counts once at most as a whole.
        private static double Covered(List<List<Vector3>> walls, float lowX, float highX, float lowY, float highY)
        {
            double sum = 0.0;
            foreach (List<Vector3> wall in walls)
            {
                List<Vector3> shape = Cut(Cut(Cut(Cut(wall, 0, lowX, 1f), 0, highX, -1f), 1, lowY, 1f), 1, highY, -1f);
                double twice = 0.0;
                for (int i = 0; i < shape.Count; i++)
                {
                    Vector3 a = shape[i], b = shape[(i + 1) % shape.Count];
                    twice += (double)a.x * b.y - (double)b.x * a.y;
                }
                sum += 0.5 * Math.Abs(twice);
            }
            return Math.Min(sum, Math.Max(0.0, ((double)highX - lowX) * ((double)highY - lowY)));
        }

        // What of a polygon is at least as far along an axis as a line (Sutherland and Hodgman 1974).
        private static List<Vector3> Cut(List<Vector3> shape, int axis, float line, float sign)
        {
            var kept = new List<Vector3>(shape.Count + 1);
            for (int i = 0; i < shape.Count; i++)
            {
                Vector3 a = shape[i], b = shape[(i + 1) % shape.Count];
                float da = sign * (a[axis] - line), db = sign * (b[axis] - line);
                if (da >= 0f) kept.Add(a);
                if (da >= 0f != db >= 0f) kept.Add(Vector3.LerpUnclamped(a, b, da / (da - db)));
            }
            return kept;
        }
    }
}
