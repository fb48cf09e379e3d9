using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Corners of a mesh that are one place: importers split them at seams of normals and texture coordinates, and rounding parts them by a
    /// little.
    /// </summary>
    internal sealed class VertexWeld
    {
        /// <param name="vertices">Corners [m].</param>
        /// <param name="within">No farther apart are two that are one [m].</param>
        public VertexWeld(Vector3[] vertices, float within)
        {
            Numbers = new int[vertices.Length];
            double side = Math.Max(8.0 * within, 1e-30);
            var cells = new Dictionary<(long, long, long), List<int>>(vertices.Length);
            for (int i = 0; i < vertices.Length; i++)
            {
                int found = Near(vertices, cells, vertices[i], within, side);
                Numbers[i] = found < 0 ? i : found;
                if (found >= 0) continue;
                (long, long, long) cell = CellOf(vertices[i], 0f, 0f, 0f, side);
                if (!cells.TryGetValue(cell, out List<int> list)) cells.Add(cell, list = new List<int>(1));
                list.Add(i);
            }
        }

        /// <summary>Of each corner the first that is at its place.</summary>
        public int[] Numbers { get; }

        private static int Near(Vector3[] vertices, Dictionary<(long, long, long), List<int>> cells, Vector3 at, float within, double side)
        {
            (long, long, long) last = default;
            for (int corner = 0; corner < 8; corner++)
            {
                (long, long, long) cell = CellOf(at, (corner & 1) == 0 ? -within : within, (corner & 2) == 0 ? -within : within,
                    (corner & 4) == 0 ? -within : within, side);
                if (corner > 0 && cell == last) continue;
                last = cell;
                if (!cells.TryGetValue(cell, out List<int> list)) continue;
                foreach (int i in list)
                    if ((vertices[i] - at).sqrMagnitude <= within * within) return i;
            }
            return -1;
        }

        private static (long, long, long) CellOf(Vector3 p, float x, float y, float z, double side) =>
            ((long)Math.Floor(((double)p.x + x) / side), (long)Math.Floor(((double)p.y + y) / side),
                (long)Math.Floor(((double)p.z + z) / side));
    }
}
