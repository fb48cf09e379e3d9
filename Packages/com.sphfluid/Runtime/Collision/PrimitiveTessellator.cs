using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Triangles of box, sphere, capsule and wheel colliders in simulation space, outward.</summary>
    internal static class PrimitiveTessellator
    {
        /// <summary>Most segments round a sphere, capsule or wheel; beyond it the chord error grows past what was asked.</summary>
        public const int MaxSegments = 64;

        private static readonly int[] BoxIndices =
        {
            0, 4, 6, 0, 6, 2, // −x
            1, 3, 7, 1, 7, 5, // +x
            0, 1, 5, 0, 5, 4, // −y
            2, 6, 7, 2, 7, 3, // +y
            0, 2, 3, 0, 3, 1, // −z
            4, 5, 7, 4, 7, 6, // +z
        };

        /// <summary>The image of the unit cube centred on the origin: 12 triangles.</summary>
        public static TriangleMesh Box(in Matrix4x4 unitToSimulation)
        {
            var corners = new Vector3[8];
            for (int i = 0; i < 8; i++) corners[i] = new Vector3((i & 1) - 0.5f, ((i >> 1) & 1) - 0.5f, (i >> 2) - 0.5f);
            return new TriangleMesh(corners, (int[])BoxIndices.Clone(), true).Transformed(unitToSimulation);
        }

        /// <summary>
        /// A capsule along the local y axis of <paramref name="pose"/>, with corners on the true surface; a sphere when
        /// <paramref name="halfLength"/> is zero.
        /// </summary>
        /// <param name="pose">Position and rotation in simulation space.</param>
        /// <param name="radius">Radius [m].</param>
        /// <param name="halfLength">Half the length of the cylinder between the caps [m].</param>
        /// <param name="chordError">Largest allowed distance between triangles and the true surface [m].</param>
        public static TriangleMesh Capsule(in Matrix4x4 pose, float radius, float halfLength, float chordError)
        {
            int segments = Segments(radius, chordError);
            int rings = Mathf.Max(1, (segments + 3) / 4);
            var vertices = new List<Vector3>();
            vertices.Add(new Vector3(0f, halfLength + radius, 0f));
            AddRings(vertices, segments, rings, radius, halfLength);
            vertices.Add(new Vector3(0f, -halfLength - radius, 0f));

            return Turned(vertices, segments).Transformed(pose);
        }

        /// <summary>A cylinder along the local y axis of <paramref name="pose"/>, with corners on the true surface.</summary>
        /// <param name="pose">Position and rotation in simulation space.</param>
        /// <param name="radius">Radius [m].</param>
        /// <param name="halfLength">Half its length [m].</param>
        /// <param name="chordError">Largest allowed distance between triangles and the true surface [m].</param>
        public static TriangleMesh Cylinder(in Matrix4x4 pose, float radius, float halfLength, float chordError)
        {
            int segments = Segments(radius, chordError);
            var vertices = new List<Vector3> { new Vector3(0f, halfLength, 0f) };
            AddRow(vertices, segments, radius, halfLength, 0.5 * Math.PI);
            AddRow(vertices, segments, radius, -halfLength, 0.5 * Math.PI);
            vertices.Add(new Vector3(0f, -halfLength, 0f));
            return Turned(vertices, segments).Transformed(pose);
        }

        /// <summary>
        /// Segments round a circle such that a chord stays within half the error (the other half is the meridians'):
        /// r(1 − cos(π/n)) ≤ e/2.
        /// </summary>
        public static int Segments(float radius, float chordError)
        {
            double cosine = Math.Max(-1.0, 1.0 - 0.5 * chordError / Math.Max(radius, 1e-20f));
            double segments = Math.Ceiling(Math.PI / Math.Max(Math.Acos(cosine), 1e-6));
            return (int)Math.Min(Math.Max(segments, 6.0), MaxSegments);
        }

        // Rows from the first below the upper pole to the last above the lower one; a sphere has one equator, a capsule two.
        private static void AddRings(List<Vector3> vertices, int segments, int rings, float radius, float halfLength)
        {
            for (int ring = 1; ring <= rings; ring++) AddRow(vertices, segments, radius, halfLength, 0.5 * Math.PI * ring / rings);
            if (halfLength > 0f) AddRow(vertices, segments, radius, -halfLength, 0.5 * Math.PI);
            for (int ring = 1; ring < rings; ring++)
            {
                AddRow(vertices, segments, radius, -halfLength, 0.5 * Math.PI * (1.0 + ring / (double)rings));
            }
        }

        private static void AddRow(List<Vector3> vertices, int segments, float radius, float offset, double polar)
        {
            double around = radius * Math.Sin(polar), height = offset + radius * Math.Cos(polar);
            for (int s = 0; s < segments; s++)
            {
                double angle = 2.0 * Math.PI * s / segments;
                vertices.Add(new Vector3((float)(around * Math.Cos(angle)), (float)height, (float)(around * Math.Sin(angle))));
            }
        }

        // The upper pole, rows of corners downwards, the lower pole.
        private static TriangleMesh Turned(List<Vector3> vertices, int segments)
        {
            var indices = new List<int>();
            int rows = (vertices.Count - 2) / segments;
            for (int s = 0; s < segments; s++)
            {
                int next = (s + 1) % segments;
                AddTriangle(indices, 0, 1 + next, 1 + s);
                for (int row = 0; row + 1 < rows; row++)
                {
                    int upper = 1 + row * segments, lower = upper + segments;
                    AddTriangle(indices, upper + s, upper + next, lower + next);
                    AddTriangle(indices, upper + s, lower + next, lower + s);
                }
                int last = 1 + (rows - 1) * segments;
                AddTriangle(indices, vertices.Count - 1, last + s, last + next);
            }
            return new TriangleMesh(vertices.ToArray(), indices.ToArray(), true);
        }

        private static void AddTriangle(List<int> indices, int a, int b, int c)
        {
            indices.Add(a);
            indices.Add(b);
            indices.Add(c);
        }
    }
}
