using System.Collections.Generic;
using SphFluid.Laboratory;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// G. Nielson, "Dual marching cubes" (2004), for comparison: a vertex for each outline that the surface draws on a cube, at the mean of
    /// its cuts, and a square of two triangles around each cut grid edge. Where two cubes' outlines both pass all four edges of the face
    /// between them, an edge of the mesh would have four triangles: with the flip, inside corners of that face are kept apart in both cubes
    /// (after R. Wenger, Isosurfaces, 2013), and the mesh is a manifold.
    /// </summary>
    internal sealed class DualMarchingCubes
    {
        // As marching cubes has them: no vertex nearer to an edge's end, and the thickness of the ring that closes the mesh at the walls.
        private const float EdgeMargin = 0.01f, Ring = 0.02f;
        private const int AllInside = 0, AllOutside = 255;

        private readonly SurfaceGrid grid;
        private readonly float[] values;
        private readonly float iso;
        private readonly Dictionary<Vector3Int, int[]> vertexOfEdge = new Dictionary<Vector3Int, int[]>();
        private readonly List<Vector3> positions = new List<Vector3>(), normals = new List<Vector3>();
        private readonly List<int> indices = new List<int>();

        private DualMarchingCubes(SurfaceGrid grid, float[] values, float iso)
        {
            this.grid = grid;
            this.values = values;
            this.iso = iso;
        }

        /// <summary>The surface of a field, closed at the walls.</summary>
        /// <param name="grid">The grid.</param>
        /// <param name="values">Field values at its vertices, x fastest; cubes with one that is not a number are left out.</param>
        /// <param name="iso">Value on the surface.</param>
        /// <param name="flip">Whether the mesh is made a manifold.</param>
        public static SurfaceMesh Polygonise(SurfaceGrid grid, float[] values, float iso, bool flip)
        {
            var dual = new DualMarchingCubes(grid, values, iso);
            Dictionary<Vector3Int, int> cases = dual.CutCubes();
            foreach (KeyValuePair<Vector3Int, int> cube in cases)
            {
                dual.AddVertices(cube.Key, cube.Value, flip ? SeparatedFaces(cases, cube.Key) : 0);
            }
            foreach (KeyValuePair<Vector3Int, int> cube in cases) dual.AddSquares(cube.Key);
            return new SurfaceMesh(dual.positions.ToArray(), dual.normals.ToArray(), dual.indices.ToArray());
        }

        private Dictionary<Vector3Int, int> CutCubes()
        {
            var cases = new Dictionary<Vector3Int, int>();
            for (int z = -1; z <= grid.Cells.z; z++)
                for (int y = -1; y <= grid.Cells.y; y++)
                    for (int x = -1; x <= grid.Cells.x; x++)
                    {
                        var cube = new Vector3Int(x, y, z);
                        int index = Case(cube);
                        if (index != AllInside && index != AllOutside) cases.Add(cube, index);
                    }
            return cases;
        }

        private int Case(Vector3Int cube)
        {
            int index = 0;
            for (int corner = 0; corner < 8; corner++)
            {
                float value = Value(cube + CubeFaceRules.Offset(corner));
                if (float.IsNaN(value)) return AllOutside;
                index |= value < iso ? 1 << corner : 0;
            }
            return index;
        }

        // Faces on which this cube and the next both pass all four edges with one outline.
        private static int SeparatedFaces(Dictionary<Vector3Int, int> cases, Vector3Int cube)
        {
            int faces = 0;
            for (int face = 0; face < CubeFaceRules.Count; face++)
            {
                if (CubeFaceRules.IsCutByOneLoop(cases[cube], face) &&
                    cases.TryGetValue(cube + CubeFaceRules.Direction(face), out int next) &&
                    CubeFaceRules.IsCutByOneLoop(next, CubeFaceRules.Opposite(face)))
                {
                    faces |= 1 << face;
                }
            }
            return faces;
        }

        private void AddVertices(Vector3Int cube, int index, int separated)
        {
            var vertices = new int[12];
            foreach (List<int> loop in CubeFaceRules.Outlines(index, separated))
            {
                Vector3 position = Vector3.zero, normal = Vector3.zero;
                foreach (int edge in loop)
                {
                    vertices[edge] = positions.Count;
                    Vector3Int a = Corner(cube, edge, 0), b = Corner(cube, edge, 1);
                    float t = Mathf.Clamp((iso - Value(a)) / (Value(b) - Value(a)), EdgeMargin, 1f - EdgeMargin);
                    position += Vector3.Lerp(Position(a), Position(b), t);
                    normal -= Vector3.Lerp(Gradient(a), Gradient(b), t);
                }
                positions.Add(position / loop.Count);
                normals.Add(normal == Vector3.zero ? Vector3.up : normal.normalized);
            }
            vertexOfEdge.Add(cube, vertices);
        }

        // The squares around the three edges that start at the cube's lowest corner.
        private void AddSquares(Vector3Int cube)
        {
            for (int axis = 0; axis < 3; axis++)
            {
                Vector3Int along = Unit(axis), right = Unit((axis + 1) % 3), up = Unit((axis + 2) % 3);
                bool inside = Value(cube) >= iso;
                if (inside == Value(cube + along) >= iso) continue;
                int a = Vertex(cube, Vector3Int.zero, along), b = Vertex(cube, right, along), c = Vertex(cube, right + up, along),
                    d = Vertex(cube, up, along);
                if (a < 0 || b < 0 || c < 0 || d < 0) continue; // a cube left out
                if (!inside) (b, d) = (d, b);
                bool first = (positions[a] - positions[c]).sqrMagnitude <= (positions[b] - positions[d]).sqrMagnitude;
                indices.AddRange(first ? new[] { a, b, c, a, c, d } : new[] { a, b, d, b, c, d });
            }
        }

        // Vertex for the edge that starts at a cube's lowest corner, of another cube around that edge; -1 where that cube is left out.
        private int Vertex(Vector3Int cube, Vector3Int offset, Vector3Int along) =>
            vertexOfEdge.TryGetValue(cube - offset, out int[] vertices)
            ? vertices[CubeFaceRules.EdgeBetween(CubeFaceRules.CornerAt(offset), CubeFaceRules.CornerAt(offset + along))]
            : -1;

        private static Vector3Int Corner(Vector3Int cube, int edge, int end) =>
            cube + CubeFaceRules.Offset(CubeNumbering.EdgeCorners[2 * edge + end]);

        private static Vector3Int Unit(int axis) => new Vector3Int(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);

        private bool IsInGrid(Vector3Int v) => Vector3Int.Max(Vector3Int.zero, Vector3Int.Min(grid.Cells, v)) == v;

        private float Value(Vector3Int v) => IsInGrid(v) ? values[grid.Index(v.x, v.y, v.z)] : 0f;

        private Vector3 Gradient(Vector3Int v)
        {
            Vector3 gradient = Vector3.zero;
            for (int axis = 0; axis < 3; axis++)
            {
                gradient[axis] = (Value(v + Unit(axis)) - Value(v - Unit(axis))) / (2f * grid.CellSize[axis]);
            }
            return float.IsNaN(gradient.sqrMagnitude) ? Vector3.zero : gradient;
        }

        private Vector3 Position(Vector3Int v)
        {
            Vector3 place = Vector3.zero;
            for (int axis = 0; axis < 3; axis++)
            {
                place[axis] = v[axis] < 0 ? 0f : v[axis] > grid.Cells[axis] ? grid.Cells[axis]
                    : Mathf.Clamp(v[axis], Ring, grid.Cells[axis] - Ring);
            }
            return grid.Minimum + Vector3.Scale(grid.CellSize, place);
        }
    }
}
