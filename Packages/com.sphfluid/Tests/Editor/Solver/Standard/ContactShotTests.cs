using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Shots at triangles through the contact kernels: no path that they let pass hits a triangle.</summary>
    public sealed class ContactShotTests
    {
        private const float Spacing = 0.01f;
        private const int Shots = 1999;

        // Triangles round a centre: soups with needles, flat pieces, duplicates and turned copies, fans, cut patches.
        internal static List<Vector3> Scene(int kind, Vector3 centre, System.Random random)
        {
            var corners = new List<Vector3>();
            Vector3 At() => centre + 0.2f * ParticleSets.RandomVector(random);
            if (kind == 0)
                for (int i = 0; i < 80; i++)
                {
                    float size = Spacing * Mathf.Pow(10f, -0.5f + 2f * (float)random.NextDouble());
                    Vector3 a = At(), b = a + size * ParticleSets.RandomVector(random), c = a + size * ParticleSets.RandomVector(random);
                    if (i % 4 == 0) c = b + 1e-3f * (c - b);
                    corners.AddRange(new[] { a, b, c });
                    if (i % 9 == 0) corners.AddRange(new[] { a, c, b });
                    if (i % 11 == 0) corners.AddRange(new[] { a, b, c });
                }
            else if (kind == 1)
                for (int fan = 0; fan < 4; fan++)
                {
                    Vector3 tip = At(), axis = ParticleSets.RandomVector(random).normalized,
                        side = Vector3.Cross(axis, ParticleSets.RandomVector(random)).normalized;
                    float length = Spacing * (1f + 8f * (float)random.NextDouble()), width = (float)random.NextDouble();
                    for (int i = 0; i < 20; i++)
                    {
                        Vector3 Rim(int k) => tip + length * (axis + width * (Quaternion.AngleAxis(18f * k, axis) * side));
                        corners.AddRange(new[] { tip, Rim(i), Rim(i + 1) });
                    }
                }
            else
            {
                Vector3 u = 0.02f * ParticleSets.RandomVector(random).normalized,
                    v = Vector3.Cross(u, ParticleSets.RandomVector(random)).normalized * 0.015f;
                Vector3 Point(int x, int y) => centre + (x - 3) * u + (y - 3) * v +
                    0.02f * Mathf.Sin(x + 2f * y) * Vector3.Cross(u, v).normalized;
                for (int x = 0; x < 6; x++)
                    for (int y = 0; y < 6; y++)
                    {
                        corners
                            .AddRange(new[] { Point(x, y), Point(x + 1, y), Point(x, y + 1), Point(x + 1, y), Point(x + 1, y + 1),
                                Point(x, y + 1) });
                    }
            }
            return corners;
        }

        private static Vector3 Aim(IReadOnlyList<Vector3> corners, System.Random random)
        {
            int t = 3 * random.Next(corners.Count / 3);
            float u = (float)random.NextDouble(), v = (float)random.NextDouble() * (1f - u);
            switch (random.Next(3))
            {
                case 0: return corners[t];
                case 1: return Vector3.Lerp(corners[t], corners[t + 1], u);
                default: return corners[t] + u * (corners[t + 1] - corners[t]) + v * (corners[t + 2] - corners[t]);
            }
        }

        [TestCase(0f, 1)]
        [TestCase(15f, 0)]
        [TestCase(15f, 1)]
        [TestCase(15f, 2)]
        public void NoShotPasses(float offset, int kind)
        {
            FluidSolverSettings settings = BodyRig.Water(new Vector3(2f * offset + 0.6f, 0.6f, 0.6f), Spacing, 0.3f);
            settings.TimeStep = 1e-3f;
            var centre = new Vector3(offset, 0f, 0f);
            int shots = 0, escapes = 0, moved = 0;
            var random = new System.Random(17 + kind);
            FluidShaderSet set = TestShaders.CreateSet();
            var walls = new GatherWallsPass(set);
            var find = new FindContactsPass(set);
            var resolve = new ResolveContactsPass(set);
            for (int scene = 0; scene < 3; scene++)
            {
                List<Vector3> corners = Scene(kind, centre, random);
                using (var rig = new BodyRig(settings))
                {
                    rig.Add(corners);
                    var from = new Vector4[Shots];
                    var to = new Vector4[Shots];
                    for (int i = 0; i < Shots; i++) Shoot(corners, random, out from[i], out to[i]);
                    rig.Start(from.Select((p, i) => new FluidParticle(p, Vector3.zero, (uint)i)).ToArray());
                    StandardState state = rig.State;
                    rig.Setup();
                    for (int round = 0; round < 2; round++) // the second from where the first came to rest
                    {
                        state.Buffers.Positions.SetData(from);
                        StandardStateRig.EmptyContacts(state);
                        state.Buffers.PositionTerms.SetData(from);
                        state.Buffers.NewPositions.SetData(to);
                        state.Buffers.NewVelocities.SetData(from.Select((p, i) => (to[i] - p) / settings.TimeStep).ToArray());
                        GpuTest.Run(cmd =>
                        {
                            walls.Record(cmd, state, state.Buffers.Positions);
                            find.Record(cmd, state, new FluidStep(settings.TimeStep, settings.TimeStep, false),
                                state.Buffers.PositionTerms);
                            resolve.Record(cmd, state, new FluidStep(settings.TimeStep, settings.TimeStep, false));
                        });
                        Vector4[] end = GpuTest.Read<Vector4>(state.Buffers.NewPositions, Shots);
                        for (int i = 0; i < Shots; i++)
                        {
                            shots++;
                            moved += end[i] == from[i] ? 0 : 1;
                            for (int t = 0; t < corners.Count; t += 3)
                                if (MayIntersect(from[i], end[i], corners, t) &&
                                    ExactGeometry.Intersects(from[i], end[i], corners[t], corners[t + 1], corners[t + 2]))
                                {
                                    escapes++;
                                    break;
                                }
                            Vector3 displacement = to[i] - from[i];
                            from[i] = end[i];
                            to[i] = end[i] + (Vector4)(Quaternion.AngleAxis(40f, Vector3.one) * displacement);
                        }
                    }
                    Assert.That(rig.Solver.ReadCountersNow().Contacts, Is.GreaterThan(Shots / 10));
                }
            }
            Object.DestroyImmediate(set);
            Assert.That(escapes, Is.Zero, $"of {shots} shots");
            Assert.That(moved, Is.GreaterThan(shots / 2));
        }

        // From at least two floors off all triangles towards a triangle, 0.01 to 8 dx.
        internal static void Shoot(List<Vector3> corners, System.Random random, out Vector4 from, out Vector4 to)
        {
            Vector3 target, p;
            float length;
            do
            {
                target = Aim(corners, random);
                length = Spacing * Mathf.Pow(10f, -2f + 2.9f * (float)random.NextDouble());
                p = target - length * (float)random.NextDouble() * ParticleSets.RandomVector(random).normalized;
            }
            while (Nearest(corners, p) < 5e-5 || (target - p).magnitude < 2e-5f);
            from = p;
            to = p + length * (target - p).normalized;
        }

        private static double Nearest(List<Vector3> corners, Vector3 p)
        {
            double nearest = double.MaxValue;
            for (int t = 0; t < corners.Count; t += 3)
            {
                nearest = System.Math.Min(nearest, ExactGeometry.Distance(p, corners[t], corners[t + 1], corners[t + 2]));
            }
            return nearest;
        }

        private static bool MayIntersect(Vector3 p, Vector3 q, List<Vector3> corners, int t)
        {
            for (int axis = 0; axis < 3; axis++)
            {
                float low = Mathf.Min(corners[t][axis], Mathf.Min(corners[t + 1][axis], corners[t + 2][axis]));
                float high = Mathf.Max(corners[t][axis], Mathf.Max(corners[t + 1][axis], corners[t + 2][axis]));
                if (Mathf.Max(p[axis], q[axis]) < low || Mathf.Min(p[axis], q[axis]) > high) return false;
            }
            return true;
        }
    }
}
