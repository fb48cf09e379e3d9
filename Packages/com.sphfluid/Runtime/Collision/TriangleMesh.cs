using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Triangles of a shape [m], apart from any Unity object. Three indices a triangle; Cross(B − A, C − A) points outward, as of
    /// Unity's clockwise front faces.
    /// </summary>
    public sealed class TriangleMesh
    {
        // Of the mesh's size.
        private const double Weld = 1e-6;

        private Joints joints = new Joints();
        private Bounds? bounds;
        private MeshObstacle obstacle;
        private MeshSurfaces surfaces;

        /// <summary>A mesh that keeps its arrays: do not change them.</summary>
        /// <param name="vertices">Corners [m].</param>
        /// <param name="indices">Three a triangle.</param>
        /// <exception cref="ArgumentNullException">An array is missing.</exception>
        /// <exception cref="ArgumentException">The indices do not make whole triangles or name corners that there are not, or a corner is
        /// not finite.</exception>
        public TriangleMesh(Vector3[] vertices, int[] indices)
            : this(vertices, indices, null)
        {
            foreach (Vector3 vertex in vertices) Require.Finite(vertex, nameof(vertices));
            foreach (int index in indices)
                if (index < 0 || index >= vertices.Length)
                {
                    throw new ArgumentOutOfRangeException(nameof(indices), index,
                        $"The mesh has {vertices.Length} corners. Use the numbers of these, from 0 on.");
                }
        }

        /// <summary>A mesh of which it is known whether it is closed; null: it is found out when asked for.</summary>
        internal TriangleMesh(Vector3[] vertices, int[] indices, bool? closed)
        {
            joints.Closed = closed;
            Vertices = vertices ?? throw new ArgumentNullException(nameof(vertices));
            Indices = indices ?? throw new ArgumentNullException(nameof(indices));
            if (indices.Length % 3 != 0) throw new ArgumentException("Three indices make a triangle.", nameof(indices));
        }

        /// <summary>Corners [m].</summary>
        public Vector3[] Vertices { get; }

        /// <summary>Three a triangle.</summary>
        public int[] Indices { get; }

        /// <summary>Number of triangles.</summary>
        public int TriangleCount => Indices.Length / 3;

        /// <summary>
        /// Whether every edge is shared by as many triangles running in one direction as in the other, so that there is an inside. Corners
        /// within a millionth of the mesh's size are one.
        /// </summary>
        public bool IsClosed => joints.Closed ??= IsBalanced();

        /// <summary>
        /// Of each corner the first that is at its place: importers split corners at seams of normals and texture coordinates, and rounding
        /// parts them by a little.
        /// </summary>
        internal int[] Welded => joints.Welded ??= new VertexWeld(Vertices, (float)(Weld * Bounds.size.magnitude)).Numbers;

        /// <summary>The corners of single triangles as a mesh.</summary>
        /// <param name="corners">Three a triangle [m].</param>
        /// <returns>The mesh.</returns>
        /// <exception cref="ArgumentException">The corners do not make whole triangles.</exception>
        public static TriangleMesh FromCorners(IReadOnlyList<Vector3> corners)
        {
            if (corners == null) throw new ArgumentNullException(nameof(corners));
            var vertices = new Vector3[corners.Count];
            var indices = new int[corners.Count];
            for (int i = 0; i < indices.Length; i++)
            {
                vertices[i] = Require.Finite(corners[i], nameof(corners));
                indices[i] = i;
            }
            return new TriangleMesh(vertices, indices);
        }

        /// <summary>A box: the image of the unit cube centred on the origin, 12 triangles.</summary>
        /// <param name="fromUnitCube">Where the cube goes, e.g. <c>Matrix4x4.TRS(centre, rotation, edges)</c>.</param>
        /// <returns>The mesh.</returns>
        public static TriangleMesh Box(in Matrix4x4 fromUnitCube) => PrimitiveTessellator.Box(fromUnitCube);

        /// <summary>
        /// Edges whose triangles do not run in one direction as often as in the other, and how much more often they run from the first
        /// corner to the second.
        /// </summary>
        internal List<(int from, int to, int times)> OpenEdges()
        {
            var open = new List<(int, int, int)>();
            foreach (KeyValuePair<(int from, int to), int> edge in Balance())
                if (edge.Value != 0) open.Add((edge.Key.from, edge.Key.to, edge.Value));
            return open;
        }

        /// <summary>Bounds of the finite corners [m].</summary>
        public Bounds Bounds => bounds ??= FindBounds();

        /// <summary>
        /// Whether a point is inside: a ray along +x, its crossings counted by their direction, leaves the surface more often than it
        /// enters. A vessel whose faces look inward holds no solid; an open mesh has no inside.
        /// </summary>
        /// <param name="point">Point [m].</param>
        /// <returns>True inside.</returns>
        public bool Contains(Vector3 point) => Obstacle.Contains(point);

        /// <summary>
        /// Times a closed surface winds round a point: 1 inside faces that look outward, −1 inside faces that look inward; 0 for an open
        /// mesh.
        /// </summary>
        /// <param name="point">Point [m].</param>
        /// <returns>The number, positive where <see cref="Contains"/> is true.</returns>
        public int Winding(Vector3 point) => Obstacle.Winding(point);

        /// <summary>Of a ray from a point along +x: how much more often it leaves through a triangle than it enters.</summary>
        internal int Crossings(Vector3 point) => Obstacle.Crossings(point);

        /// <summary>Whether a point is nearer than a distance to a triangle.</summary>
        /// <param name="point">Point [m].</param>
        /// <param name="distance">Distance [m]; nothing is nearer than 0.</param>
        /// <returns>True when it is.</returns>
        public bool IsNear(Vector3 point, float distance) => Obstacle.IsNear(point, distance);

        /// <summary>The triangles under an affine transform; a mirroring one turns each triangle so that outward stays outward.</summary>
        /// <param name="transform">The transform.</param>
        /// <returns>A new mesh.</returns>
        public TriangleMesh Transformed(in Matrix4x4 transform)
        {
            var vertices = new Vector3[Vertices.Length];
            for (int i = 0; i < vertices.Length; i++) vertices[i] = transform.MultiplyPoint3x4(Vertices[i]);
            if (!(AffineMath.Determinant(transform) < 0.0)) return With(vertices, Indices);
            var indices = (int[])Indices.Clone();
            for (int i = 0; i < indices.Length; i += 3) (indices[i + 1], indices[i + 2]) = (indices[i + 2], indices[i + 1]);
            return With(vertices, indices);
        }

        /// <summary>The triangles under a map that does not mirror, each corner rounded once.</summary>
        internal TriangleMesh Transformed(in AffineMap map)
        {
            var vertices = new Vector3[Vertices.Length];
            for (int i = 0; i < vertices.Length; i++) vertices[i] = map.Apply(Vertices[i]);
            return With(vertices, Indices);
        }

        /// <summary>
        /// The same triangles with other corners, as of a mesh that deforms. What is closed stays closed: corners at one place must stay
        /// together.
        /// </summary>
        /// <param name="vertices">As many as there are now [m]; the array is kept.</param>
        /// <returns>A new mesh.</returns>
        /// <exception cref="ArgumentException">It is another number of them.</exception>
        public TriangleMesh Deformed(Vector3[] vertices)
        {
            if (vertices == null) throw new ArgumentNullException(nameof(vertices));
            if (vertices.Length != Vertices.Length)
            {
                throw new ArgumentException($"The mesh has {Vertices.Length} corners, but {vertices.Length} were given.", nameof(vertices));
            }
            TriangleMesh deformed = With(vertices, Indices);
            deformed.surfaces = Surfaces.Deforming;
            return deformed;
        }

        /// <summary>Which triangles make up one surface.</summary>
        internal MeshSurfaces Surfaces => surfaces ??= new MeshSurfaces(this);

        /// <summary>Whether another mesh has the same triangles, its corners apart.</summary>
        internal bool HasTrianglesOf(TriangleMesh other)
        {
            if (Vertices.Length != other.Vertices.Length) return false;
            return ReferenceEquals(Indices, other.Indices) || Indices.AsSpan().SequenceEqual(other.Indices);
        }

        /// <summary>A triangle's corners [m].</summary>
        /// <param name="index">Number of the triangle, less than <see cref="TriangleCount"/>.</param>
        /// <param name="a">First corner.</param>
        /// <param name="b">Second corner.</param>
        /// <param name="c">Third corner.</param>
        public void GetTriangle(int index, out Vector3 a, out Vector3 b, out Vector3 c)
        {
            a = Vertices[Indices[3 * index]];
            b = Vertices[Indices[3 * index + 1]];
            c = Vertices[Indices[3 * index + 2]];
        }

        /// <summary>
        /// Whether a triangle has no area to speak of: its height over its longest edge is below 1e-5 of that edge, or a
        /// corner is not finite.
        /// </summary>
        internal static bool IsDegenerate(Vector3 a, Vector3 b, Vector3 c)
        {
            if (!AffineMath.IsFinite(a) || !AffineMath.IsFinite(b) || !AffineMath.IsFinite(c)) return true;
            Vector3 ab = b - a, ac = c - a, bc = c - b;
            float longest = Mathf.Max(ab.sqrMagnitude, Mathf.Max(ac.sqrMagnitude, bc.sqrMagnitude));
            return !(longest > 0f) || Vector3.Cross(ab / Mathf.Sqrt(longest), ac / Mathf.Sqrt(longest)).magnitude < 1e-5f;
        }

        /// <summary>Whether a point is inside or nearer than a clearance [m] to a triangle.</summary>
        internal bool Covers(Vector3 point, float clearance) => Obstacle.Covers(point, clearance);

        /// <summary>The place on a triangle that is nearest to a point, nearer than a distance [m]; null where there is none.</summary>
        internal Vector3? Nearest(Vector3 point, float within) => Obstacle.Nearest(point, within);

        // Prepared at the first use.
        private MeshObstacle Obstacle => obstacle ??= new MeshObstacle(this);

        private TriangleMesh With(Vector3[] vertices, int[] indices)
        {
            _ = Welded; // a copy that is flat has corners at one place that are apart in the others
            return new TriangleMesh(vertices, indices, null) { joints = joints };
        }

        private bool IsBalanced()
        {
            Dictionary<(int, int), int> balance = Balance();
            foreach (int value in balance.Values)
                if (value != 0) return false;
            return balance.Count > 0; // else no triangle has three corners
        }

        private Dictionary<(int from, int to), int> Balance()
        {
            var balance = new Dictionary<(int, int), int>();
            int[] welded = Welded;
            for (int i = 0; i < Indices.Length; i += 3)
            {
                int a = welded[Indices[i]], b = welded[Indices[i + 1]], c = welded[Indices[i + 2]];
                if (a == b || b == c || c == a) continue;
                AddEdge(balance, a, b);
                AddEdge(balance, b, c);
                AddEdge(balance, c, a);
            }
            return balance;
        }

        private Bounds FindBounds()
        {
            Vector3 min = Vector3.positiveInfinity, max = Vector3.negativeInfinity;
            foreach (int index in Indices)
            {
                Vector3 vertex = Vertices[index];
                if (!AffineMath.IsFinite(vertex)) continue;
                min = Vector3.Min(min, vertex);
                max = Vector3.Max(max, vertex);
            }
            var found = new Bounds();
            if (min.x <= max.x) found.SetMinMax(min, max);
            return found;
        }

        private static void AddEdge(Dictionary<(int, int), int> balance, int from, int to)
        {
            (int, int) key = from < to ? (from, to) : (to, from);
            balance.TryGetValue(key, out int value);
            balance[key] = value + (from < to ? 1 : -1);
        }

        // How corners hang together, wherever they are.
        private sealed class Joints
        {
            public bool? Closed;
            public int[] Welded;
        }
    }
}
