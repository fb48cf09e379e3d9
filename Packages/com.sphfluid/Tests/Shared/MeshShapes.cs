using System.Collections.Generic;

namespace SphFluid.Tests
{
    /// <summary>Meshes for the collision tests; cross(B − A, C − A) points outwards.</summary>
    internal static class MeshShapes
    {
        /// <summary>Axis-aligned box, closed, each face cut into n × n squares of two triangles.</summary>
        public static ReferenceMesh Box(Double3 centre, Double3 half, int n)
        {
            var mesh = new ReferenceMesh { Closed = true };
            for (int axis = 0; axis < 3; axis++)
            {
                for (int sign = -1; sign <= 1; sign += 2) AddFace(mesh, centre, half, axis, sign, n);
            }

            return mesh;
        }

        /// <summary>One triangle, open.</summary>
        public static ReferenceMesh Triangle(Double3 a, Double3 b, Double3 c)
        {
            return new ReferenceMesh { Triangles = new List<Double3[]> { new[] { a, b, c } } };
        }

        private static void AddFace(ReferenceMesh mesh, Double3 centre, Double3 half, int axis, int sign, int n)
        {
            for (int u = 0; u < n; u++)
            {
                for (int v = 0; v < n; v++)
                {
                    Double3 a = Point(centre, half, axis, sign, u, v, n);
                    Double3 b = Point(centre, half, axis, sign, u + 1, v, n);
                    Double3 c = Point(centre, half, axis, sign, u + 1, v + 1, n);
                    Double3 d = Point(centre, half, axis, sign, u, v + 1, n);
                    mesh.Triangles.Add(sign > 0 ? new[] { a, b, c } : new[] { a, c, b });
                    mesh.Triangles.Add(sign > 0 ? new[] { a, c, d } : new[] { a, d, c });
                }
            }
        }

        // u and v run along the two axes after the face's own, so that axis, u, v are right-handed.
        private static Double3 Point(Double3 centre, Double3 half, int axis, int sign, int u, int v, int n)
        {
            double s = 2.0 * u / n - 1.0;
            double t = 2.0 * v / n - 1.0;
            switch (axis)
            {
                case 0: return centre + new Double3(sign * half.X, s * half.Y, t * half.Z);
                case 1: return centre + new Double3(t * half.X, sign * half.Y, s * half.Z);
                default: return centre + new Double3(s * half.X, t * half.Y, sign * half.Z);
            }
        }
    }
}
