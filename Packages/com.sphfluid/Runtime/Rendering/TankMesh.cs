using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// The shape of a tank round a box: panes as submesh 0, the bars of its edges as submesh 1. All of it lies outside the box.
    /// </summary>
    internal sealed class TankMesh
    {
        private const int Quad = 4;
        private const float Apart = 0.125f; // of a bar: what stands at the box, such as a floor, is not in the plane of the bar's face

        private readonly List<Vector3> positions = new List<Vector3>();
        private readonly List<Vector3> normals = new List<Vector3>();
        private readonly List<int> indices = new List<int>();

        /// <summary>Makes a mesh anew.</summary>
        /// <param name="mesh">Receives the shape.</param>
        /// <param name="size">Edge lengths of the box [m]; its centre is the origin.</param>
        /// <param name="bar">Thickness of the bars [m]; 0: there are none.</param>
        /// <param name="lid">Whether there is a pane above.</param>
        public static void Fill(Mesh mesh, Vector3 size, float bar, bool lid)
        {
            var made = new TankMesh();
            made.AddPanes(0.5f * size, bar, lid);
            int panes = made.indices.Count;
            if (bar > 0f) made.AddBars(0.5f * size, bar);
            mesh.Clear();
            mesh.SetVertices(made.positions);
            mesh.SetNormals(made.normals);
            mesh.subMeshCount = 2;
            mesh.SetIndices(made.indices.GetRange(0, panes), MeshTopology.Triangles, 0);
            mesh.SetIndices(made.indices.GetRange(panes, made.indices.Count - panes), MeshTopology.Triangles, 1);
        }

        // Half-way through the bars, so that neither liquid nor floor lies in their plane.
        private void AddPanes(Vector3 half, float bar, bool lid)
        {
            float away = 0.5f * bar;
            for (int axis = 0; axis < 3; axis++)
                for (int side = -1; side <= 1; side += 2)
                    if (axis != 1 || side < 0 || lid) AddFace(Vector3.zero, half, axis, side, away);
        }

        // Those along x reach over the corners.
        private void AddBars(Vector3 half, float bar)
        {
            for (int axis = 0; axis < 3; axis++)
            {
                int u = (axis + 1) % 3, v = (axis + 2) % 3;
                for (int corner = 0; corner < 4; corner++)
                {
                    Vector3 centre = Vector3.zero, extents = 0.5f * (1f - Apart) * bar * Vector3.one;
                    centre[u] = ((corner & 1) == 0 ? -1f : 1f) * (half[u] + 0.5f * (1f + Apart) * bar);
                    centre[v] = ((corner & 2) == 0 ? -1f : 1f) * (half[v] + 0.5f * (1f + Apart) * bar);
                    extents[axis] = half[axis] + (axis == 0 ? bar : 0f);
                    for (int face = 0; face < 6; face++) AddFace(centre, extents, face / 2, face % 2 == 0 ? -1 : 1, 0f);
                }
            }
        }

        // Clockwise as seen from outside.
        private void AddFace(Vector3 centre, Vector3 half, int axis, int side, float away)
        {
            Vector3 normal = Vector3.zero, u = Vector3.zero, v = Vector3.zero;
            normal[axis] = side;
            u[(axis + 1) % 3] = side * half[(axis + 1) % 3];
            v[(axis + 2) % 3] = half[(axis + 2) % 3];
            Vector3 middle = centre + normal * (half[axis] + away);
            int first = positions.Count;
            positions.AddRange(new[] { middle - u - v, middle + u - v, middle + u + v, middle - u + v });
            for (int i = 0; i < Quad; i++) normals.Add(normal);
            indices.AddRange(new[] { first, first + 1, first + 2, first, first + 2, first + 3 });
        }
    }
}
