using System;
using System.Collections.Generic;

namespace SphFluid.Tests
{
    /// <summary>A mesh of the collision tests, in simulation space.</summary>
    public sealed class ReferenceMesh
    {
        public bool Closed;
        public List<Double3[]> Triangles = new List<Double3[]>();
    }

    /// <summary>The collision force by other means than the shader: barycentric solve for faces, segments for edges.</summary>
    public static class CollisionReference
    {
        public static Double3 Force(IReadOnlyList<ReferenceMesh> meshes, Double3 position, Double3 velocity, in FluidSolverSettings s)
        {
            Double3 force = Domain(position, velocity, s);
            foreach (ReferenceMesh mesh in meshes) force += Mesh(mesh, position, velocity, s);

            return force;
        }

        public static Double3 Wall(Double3 normal, double distance, Double3 velocity, in FluidSolverSettings s)
        {
            if (distance >= s.Own<ThesisSettings>().WallDistance) return Double3.Zero;

            double push = s.Own<ThesisSettings>().WallStiffness * (s.Own<ThesisSettings>().WallDistance - distance) -
                s.Own<ThesisSettings>().WallDamping * Double3.Dot(velocity, normal);
            return Math.Max(0.0, push) * normal;
        }

        private static Double3 Domain(Double3 p, Double3 v, in FluidSolverSettings s)
        {
            var half = 0.5 * (Double3)s.DomainSize;
            return Wall(new Double3(1, 0, 0), p.X + half.X, v, s) + Wall(new Double3(-1, 0, 0), half.X - p.X, v, s)
                + Wall(new Double3(0, 1, 0), p.Y + half.Y, v, s) + Wall(new Double3(0, -1, 0), half.Y - p.Y, v, s)
                + Wall(new Double3(0, 0, 1), p.Z + half.Z, v, s) + Wall(new Double3(0, 0, -1), half.Z - p.Z, v, s);
        }

        private static Double3 Mesh(ReferenceMesh mesh, Double3 p, Double3 v, in FluidSolverSettings s)
        {
            double nearest = double.PositiveInfinity;
            Double3 foot = Double3.Zero;
            Double3 footNormal = Double3.Zero;
            Double3 faces = Double3.Zero;
            bool contact = false;
            double firstHit = 1.0;
            Double3 hitNormal = Double3.Zero;
            foreach (Double3[] t in mesh.Triangles)
            {
                Double3 normal = Double3.Cross(t[1] - t[0], t[2] - t[0]);
                normal = normal / normal.Length;
                double height = Double3.Dot(p - t[0], normal);
                double side = mesh.Closed || height >= 0.0 ? 1.0 : -1.0;
                Double3 q = Closest(t, p, normal, out bool onFace);
                double distance = (p - q).Length;
                if (distance < nearest - 1e-4 * s.Own<ThesisSettings>().WallDistance)
                {
                    nearest = distance;
                    foot = q;
                    footNormal = normal;
                }
                else if (distance < nearest + 1e-4 * s.Own<ThesisSettings>().WallDistance)
                {
                    footNormal += normal;
                }

                if (onFace && side * height >= 0.0 && side * height < s.Own<ThesisSettings>().WallDistance)
                {
                    faces += Wall(side * normal, side * height, v, s);
                    contact = true;
                }

                double approach = Double3.Dot(v, normal) * side;
                double hit = approach < 0.0 ? -side * height / (approach * s.TimeStep) : 2.0;
                if (hit >= 0.0 && hit < firstHit && Inside(t, p + hit * s.TimeStep * v, normal))
                {
                    firstHit = hit;
                    hitNormal = side * normal;
                }
            }

            Double3 force = faces;
            bool behind = mesh.Closed && Double3.Dot(p - foot, footNormal) < 0.0;
            if (behind && nearest < s.Spacing)
            {
                force = Wall((foot - p) / nearest, -Math.Min(nearest, s.Own<ThesisSettings>().WallDistance), v, s);
            }
            else if (!contact && nearest < s.Own<ThesisSettings>().WallDistance)
            {
                force = Wall((p - foot) / nearest, nearest, v, s);
            }

            double missing = -Double3.Dot(v, hitNormal) * (1.0 - firstHit) / s.TimeStep - Double3.Dot(force, hitNormal);
            return firstHit < 1.0 && missing > 0.0 ? force + missing * hitNormal : force;
        }

        private static Double3 Closest(Double3[] t, Double3 p, Double3 normal, out bool onFace)
        {
            Double3 projected = p - Double3.Dot(p - t[0], normal) * normal;
            onFace = Inside(t, projected, normal);
            if (onFace) return projected;

            Double3 best = t[0];
            for (int i = 0; i < 3; i++)
            {
                Double3 a = t[i];
                Double3 edge = t[(i + 1) % 3] - a;
                double along = Math.Min(1.0, Math.Max(0.0, Double3.Dot(p - a, edge) / Double3.Dot(edge, edge)));
                Double3 q = a + along * edge;
                best = (p - q).Length < (p - best).Length ? q : best;
            }

            return best;
        }

        // On the inner side of each edge.
        private static bool Inside(Double3[] t, Double3 q, Double3 normal)
        {
            for (int i = 0; i < 3; i++)
            {
                if (Double3.Dot(Double3.Cross(t[(i + 1) % 3] - t[i], q - t[i]), normal) < 0.0) return false;
            }

            return true;
        }
    }
}
