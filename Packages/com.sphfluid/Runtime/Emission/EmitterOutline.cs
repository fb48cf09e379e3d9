using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A mesh as a nozzle: what is seen of it from ahead, along the emitter's forward axis. Liquid leaves from its front at the places of a
    /// square lattice, each as many spacings ahead of the emitter as the mesh is there, so that all particles are still one lattice that
    /// moves.
    /// </summary>
    internal sealed class EmitterOutline
    {
        // Nodes a spacing along each axis: of these, the four lattices with a place or the corner of a cell in the middle.
        private const int Fine = 2;

        // Nodes of the picture of a mesh.
        private const int MostNodes = 16 * EmitterSites.Most * Fine * Fine;

        // Over the spacing, unlike for both axes: corners of meshes are on the lattice often, and nodes on an edge belong to one side.
        private const float ShiftX = 1.3e-3f, ShiftY = 1.7e-3f;

        private readonly Mesh mesh;
        private readonly MeshStamp stamp;
        private readonly Vector3 scale;
        private readonly float spacing;

        private EmitterOutline(in EmitterSpec emitter, float spacing)
        {
            mesh = emitter.Mesh;
            stamp = MeshStamp.Read(mesh);
            scale = emitter.Scale;
            this.spacing = spacing;
            Places = Find(mesh, scale, spacing);
        }

        /// <summary>
        /// The places of a layer in the emitter's space [m]; none where the mesh is narrower than the lattice, or too large.
        /// </summary>
        public Vector3[] Places { get; }

        /// <summary>The outline of an emitter of the shape Mesh, made anew where its mesh, scale or spacing are others.</summary>
        /// <param name="emitter">The emitter; without a mesh that can be read it has no places.</param>
        /// <param name="spacing">Particle spacing [m].</param>
        public static EmitterOutline Create(in EmitterSpec emitter, float spacing)
        {
            EmitterOutline known = emitter.State?.Outline;
            bool serves = known != null && ReferenceEquals(known.mesh, emitter.Mesh) && known.stamp.Equals(MeshStamp.Read(emitter.Mesh)) &&
                known.scale.Equals(emitter.Scale) && known.spacing.Equals(spacing);
            if (serves) return known;
            var made = new EmitterOutline(emitter, spacing);
            if (emitter.State != null) emitter.State.Outline = made;
            return made;
        }

        private static Vector3[] Find(Mesh mesh, Vector3 scale, float spacing)
        {
            if (mesh == null || !mesh.isReadable) return Array.Empty<Vector3>(); // a check says so
            TriangleMesh triangles = new MeshReader().Read(mesh).Transformed(Matrix4x4.Scale(scale));
            float step = spacing / Fine;
            Bounds bounds = triangles.Bounds;
            Vector2Int low = Vector2Int.FloorToInt((Vector2)bounds.min / step) - Vector2Int.one,
                high = Vector2Int.CeilToInt((Vector2)bounds.max / step) + Vector2Int.one;
            double nodes = (high.x - low.x + 1.0) * (high.y - low.y + 1.0);
            if (triangles.TriangleCount == 0 || !AffineMath.IsFinite(bounds.size) || !(nodes > 0.0 && nodes <= MostNodes))
            {
                return Array.Empty<Vector3>();
            }
            int width = high.x - low.x + 1;
            var front = new float[(int)nodes];
            for (int i = 0; i < front.Length; i++) front[i] = float.NegativeInfinity;
            for (int t = 0; t < triangles.TriangleCount; t++)
            {
                triangles.GetTriangle(t, out Vector3 a, out Vector3 b, out Vector3 c);
                Draw(a, b, c, step, spacing, low, width, front);
            }
            return Best(front, low, width, step, spacing, bounds.center);
        }

        // The largest z of the triangles over each node.
        private static void Draw(Vector3 a, Vector3 b, Vector3 c, float step, float spacing, Vector2Int low, int width, float[] front)
        {
            double area = Cross(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
            if (area == 0.0) return; // seen edge on
            Vector2 least = Vector2.Min(a, Vector2.Min(b, c)), most = Vector2.Max(a, Vector2.Max(b, c));
            int x0 = Mathf.FloorToInt(least.x / step), x1 = Mathf.CeilToInt(most.x / step);
            int y0 = Mathf.FloorToInt(least.y / step), y1 = Mathf.CeilToInt(most.y / step);
            for (int y = y0; y <= y1; y++)
                for (int x = x0; x <= x1; x++)
                {
                    double px = x * step + ShiftX * spacing, py = y * step + ShiftY * spacing;
                    double u = Cross(b.x - px, b.y - py, c.x - px, c.y - py) / area;
                    double v = Cross(c.x - px, c.y - py, a.x - px, a.y - py) / area;
                    double w = 1.0 - u - v;
                    if (u < 0.0 || v < 0.0 || w < 0.0) continue;
                    int node = (y - low.y) * width + x - low.x;
                    front[node] = Mathf.Max(front[node], (float)(u * a.z + v * b.z + w * c.z));
                }
        }

        // Of the four lattices the one whose number of places is nearest to the area that is seen, and of equal ones the one nearest to the
        // middle.
        private static Vector3[] Best(float[] front, Vector2Int low, int width, float step, float spacing, Vector2 middle)
        {
            var lattices = new List<Vector3>[Fine * Fine];
            for (int i = 0; i < lattices.Length; i++) lattices[i] = new List<Vector3>();
            int seen = 0;
            for (int i = 0; i < front.Length; i++)
            {
                if (float.IsNegativeInfinity(front[i])) continue;
                int x = i % width + low.x, y = i / width + low.y;
                lattices[(x & 1) + Fine * (y & 1)].Add(new Vector3(x * step, y * step, spacing * Mathf.Round(front[i] / spacing)));
                seen++;
            }
            List<Vector3> best = lattices[0];
            foreach (List<Vector3> lattice in lattices)
                if (Off(lattice, seen, middle, spacing) < Off(best, seen, middle, spacing)) best = lattice;
            return best.ToArray();
        }

        private static double Off(List<Vector3> lattice, int seen, Vector2 middle, float spacing)
        {
            Vector2 sum = Vector2.zero;
            foreach (Vector3 place in lattice) sum += (Vector2)place - middle;
            double aside = sum.magnitude / (spacing * Math.Max(1, lattice.Count));
            return Math.Abs(lattice.Count * Fine * Fine - seen) + aside / (1.0 + aside);
        }

        private static double Cross(double ax, double ay, double bx, double by) => ax * by - ay * bx;
    }
}
