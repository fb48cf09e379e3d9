using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>GatherWalls: the walls that particles feel of triangles, against closed forms of planes and boxes.</summary>
    public sealed class GatherWallsTests
    {
        private const float Spacing = 0.05f;

        private static List<Vector3> Box(Vector3 size, int cuts)
        {
            var corners = new List<Vector3>();
            for (int axis = 0; axis < 3; axis++)
                foreach (float side in new[] { -0.5f, 0.5f })
                {
                    Sheet(corners, p => Vector3.Scale(size, Turn(new Vector3(side, p.x - 0.5f, p.y - 0.5f), axis)), cuts, side < 0f);
                }
            return corners;
        }

        private static Vector3 Turn(Vector3 v, int axis) => axis == 0 ? v : axis == 1 ? new Vector3(v.z, v.x, v.y)
            : new Vector3(v.y, v.z, v.x);

        internal static void Sheet(List<Vector3> corners, Func<Vector2, Vector3> at, int cuts, bool flip)
        {
            for (int y = 0; y < cuts; y++)
                for (int x = 0; x < cuts; x++)
                {
                    Vector3 a = at(new Vector2(x, y) / cuts), b = at(new Vector2(x + 1, y) / cuts), c = at(new Vector2(x, y + 1) / cuts),
                        d = at(new Vector2(x + 1, y + 1) / cuts);
                    // any orientation serves
                    corners.AddRange(flip != ((x + y) % 3 == 0) ? new[] { a, b, d, a, d, c } : new[] { a, c, b, b, c, d });
                }
        }

        private static StoredWall[] Gather(BodyRig rig, Vector3[] points)
        {
            rig.Start(points.Select((p, i) => new FluidParticle(p, Vector3.zero, (uint)i)).ToArray());
            rig.Setup();
            uint[] ids = rig.Particles().Select(p => p.Id).ToArray();
            StoredWall[] walls = StoredWall.Read(rig.State), result = new StoredWall[points.Length];
            for (int i = 0; i < points.Length; i++) result[ids[i]] = walls[i];
            return result;
        }

        // The six faces of a box as its inside sees them.
        private static Double3[] Inside(Vector3 size)
        {
            var corners = new List<Double3>();
            for (int axis = 0; axis < 3; axis++)
                foreach (float side in new[] { -0.5f, 0.5f })
                {
                    Double3 At(float u, float v) => Vector3.Scale(size, Turn(new Vector3(side, u, v), axis));
                    Double3 a = At(-0.5f, -0.5f), b = At(0.5f, -0.5f), c = At(0.5f, 0.5f), d = At(-0.5f, 0.5f);
                    corners.AddRange(Double3.Dot(Double3.Cross(b - a, c - a), -a) > 0.0 ? new[] { a, b, c, a, c, d }
                        : new[] { a, c, b, a, d, c });
                }
            return corners.ToArray();
        }

        private static double Share(Vector3 point, Double3[] corners, in FluidSolverSettings settings) =>
            ShadowReference.Share(point, corners, settings.SupportRadius, settings.Spacing);

        internal static Vector3[] Points(int count, Vector3 size, int seed) =>
            ParticleSets.Random(count, size, 0f, seed).Select(p => p.Position).ToArray();

        [Test]
        public void WallStrideIsTheSizeOfTheStruct() =>
            Assert.That(Marshal.SizeOf<StoredWall.Packed>(), Is.EqualTo(MeshWallBuffers.WallStride));

        [TestCase(1)]
        [TestCase(5)]
        [TestCase(12)]
        public void ABoxOfTrianglesIsABoxOfPlanesHoweverItIsCut(int cuts)
        {
            var size = new Vector3(0.5f, 0.4f, 0.6f);
            FluidSolverSettings settings = BodyRig.Water(Vector3.one, Spacing, 0.3f);
            Double3[] faces = Inside(size);
            using (var rig = new BodyRig(settings))
            {
                rig.Add(Box(size, cuts));
                Vector3[] points = Points(251, size - 0.4f * Spacing * Vector3.one, 3);
                StoredWall[] walls = Gather(rig, points);
                int felt = 0;
                for (int i = 0; i < points.Length; i++)
                {
                    double expected = Share(points[i], faces, settings);
                    Assert.That(walls[i].Value, Is.EqualTo(expected).Within(1e-3), $"at {points[i]}");
                    if (expected == 0.0) continue;
                    felt++;
                    Double3 gradient = ShadowReference.Gradient(points[i], faces, settings.SupportRadius, Spacing);
                    Assert.That((walls[i].Push - gradient).Length, Is.LessThan(0.02 / Spacing), $"at {points[i]}");
                }
                Assert.That(felt, Is.GreaterThan(100));
            }
        }

        // On positions that the test puts there.
        // The floor and the ceiling of the domain stand inside the box, square to its walls.
        [Test]
        public void FacesThatAreMirrorsHaveNoShare([Values] bool areMirrors)
        {
            var size = new Vector3(0.5f, 0.4f, 0.6f);
            FluidSolverSettings settings = BodyRig.Water(size + Spacing * new Vector3(1f, -2f, 1f), Spacing, 0.3f);
            if (areMirrors) settings = CorrectionReference.Corrected(settings);
            Double3[] faces = Inside(size);
            using (var rig = new BodyRig(settings))
            {
                rig.Add(Box(size, 5));
                Vector3[] points = Points(251, size - Spacing * new Vector3(0.4f, 2.4f, 0.4f), 3);
                StoredWall[] walls = Gather(rig, points);
                double most = points.Select((p, i) => Math.Abs(walls[i].Value - Share(p, faces, settings))).Max();
                Assert.That(most, areMirrors ? Is.LessThan(1e-3) : Is.GreaterThan(1e-2));
            }
        }

        [Test]
        public void EachParticleOfAnyNumberHasItsWalls([Values(1, 63, 64, 65, 257, 1009)] int count)
        {
            var size = new Vector3(0.5f, 0.4f, 0.6f);
            FluidSolverSettings settings = BodyRig.Water(Vector3.one, Spacing, 0.3f);
            Double3[] faces = Inside(size);
            FluidShaderSet set = TestShaders.CreateSet();
            using (var rig = new BodyRig(settings))
            {
                rig.Add(Box(size, 2));
                rig.Start(ParticleSets.Random(count, 0.1f * Vector3.one, 0f, 1));
                rig.Setup();
                Vector3[] points = Points(count, 0.98f * size, count);
                rig.State.Buffers.Positions.SetData(points.Select(p => (Vector4)p).ToArray());
                rig.State.List.WallSlot.SetData(Enumerable.Repeat(4242u, count).ToArray());
                GpuTest.Run(cmd => new GatherWallsPass(set).Record(cmd, rig.State, rig.State.Buffers.Positions));
                uint[] slots = rig.State.List.WallSlot.Read<uint>(count);
                StoredWall[] walls = StoredWall.Read(rig.State);
                for (int i = 0; i < count; i++)
                {
                    double near = double.MaxValue;
                    for (int axis = 0; axis < 3; axis++) near = Math.Min(near, 0.5 * size[axis] - Math.Abs(points[i][axis]));
                    if (Math.Abs(near / settings.SupportRadius - 1.0) > 3e-5)
                    {
                        Assert.That(slots[i] != 0u, Is.EqualTo(near < settings.SupportRadius), $"whether {i} has a wall");
                    }
                    if (near < 0.2 * Spacing || i % 7 != 0) continue; // the reference takes its time
                    Assert.That(slots[i] == 0u ? 0.0 : walls[i].Value, Is.EqualTo(Share(points[i], faces, settings)).Within(1e-3),
                        $"walls of {i}");
                }
            }
            UnityEngine.Object.DestroyImmediate(set);
        }

        // To any triangle, of a body at rest.
        [Test]
        public void TheGapIsTheDistanceToTheNearestTriangle([Values(1, 63, 64, 65, 257, 1009)] int count)
        {
            FluidSolverSettings settings = BodyRig.Water(Vector3.one, Spacing, 0.3f);
            var random = new System.Random(count);
            var corners = new List<Vector3>();
            for (int t = 0; t < 12; t++)
            {
                Vector3 at = 0.6f * ParticleSets.RandomVector(random);
                for (int k = 0; k < 3; k++) corners.Add(at + 0.3f * ParticleSets.RandomVector(random));
            }
            using (var rig = new BodyRig(settings))
            {
                rig.Add(corners);
                rig.Start(ParticleSets.Random(count, 0.9f * Vector3.one, 0f, 2));
                rig.Setup();
                Vector4[] at = GpuTest.Read<Vector4>(rig.State.Buffers.Positions, count);
                Vector4[] gaps = rig.State.Walls.WallGap.Read<Vector4>(count);
                for (int i = 0; i < count; i++)
                {
                    double nearest = settings.SupportRadius;
                    for (int t = 0; t < corners.Count; t += 3)
                    {
                        nearest = Math.Min(nearest, ExactGeometry.Distance(at[i], corners[t], corners[t + 1], corners[t + 2]));
                    }
                    Assert.That((Vector3)gaps[i], Is.EqualTo((Vector3)at[i]));
                    Assert.That(gaps[i].w, Is.LessThanOrEqualTo(nearest).And.GreaterThan(0.998 * nearest - 1e-6), $"particle {i}");
                }
            }
        }

        [Test]
        public void ASheetIsAWallFromBothSides()
        {
            FluidSolverSettings settings = BodyRig.Water(Vector3.one, Spacing, 0.3f);
            using (var rig = new BodyRig(settings))
            {
                var corners = new List<Vector3>();
                Sheet(corners, p => new Vector3(p.x - 0.5f, 0.3f * (p.x - 0.5f), p.y - 0.5f), 7, false);
                rig.Add(corners);
                Vector3 normal = new Vector3(-0.3f, 1f, 0f).normalized;
                float[] distances = { 0.003f, 0.01f, 0.024f, 0.049f };
                Vector3[] points = distances
                    .SelectMany(d => new[] { d * normal + 0.011f * Vector3.forward, -d * normal + 0.011f * Vector3.forward }).ToArray();
                StoredWall[] walls = Gather(rig, points);
                for (int i = 0; i < points.Length; i++)
                {
                    double expected = ShadowReference.Plane(distances[i / 2], settings.SupportRadius, Spacing);
                    Assert.That(walls[i].Value, Is.EqualTo(expected).Within(3e-4));
                    Assert.That((walls[i].Normal - (i % 2 == 0 ? normal : -normal)).magnitude, Is.LessThan(5e-5f));
                    Assert.That(walls[i].Distance, Is.EqualTo(distances[i / 2]).Within(0.1).Percent);
                    Assert.That(walls[i].Friction, Is.EqualTo(1023u), "the domain's");
                    Assert.That(walls[i].Flags, Is.EqualTo(1u), "one face, which is a triangle's");
                }
            }
        }

        // Where the foot of the particle in a triangle's plane is a corner or on an edge, to the last bit, an angle has no direction.
        [Test]
        public void StraightOverCornersAndEdgesAPlaneIsAPlane()
        {
            const float spacing = 0.0625f, cell = 0.125f;
            var corners = new List<Vector3>();
            Sheet(corners, p => new Vector3(8f * cell * (p.x - 0.5f), 0f, 8f * cell * (p.y - 0.5f)), 8, false);
            Vector3[] points = Enumerable.Range(0, 81)
                .Select(i => new Vector3(0.5f * cell * (i % 9 - 4), (1 + i % 3) * 0.015625f, 0.5f * cell * (i / 9 - 4))).ToArray();
            using (var rig = new BodyRig(BodyRig.Water(new Vector3(2f, 1f, 2f), spacing, 0.3f)))
            {
                rig.Add(corners);
                StoredWall[] walls = Gather(rig, points);
                for (int i = 0; i < points.Length; i++)
                {
                    double expected = ShadowReference.Plane(points[i].y, rig.Settings.SupportRadius, spacing);
                    Assert.That(walls[i].Value, Is.EqualTo(expected).Within(3e-4), $"at {points[i].ToString("f4")}");
                    Assert.That(walls[i].Push.X, Is.EqualTo(0.0).Within(1e-3 / spacing), $"at {points[i].ToString("f4")}");
                }
            }
        }

        // Beyond an edge less of a wall is seen.
        [TestCase(0.4f, 20f)]
        [TestCase(0.3f, 45f)]
        [TestCase(0.2f, 70f)]
        [TestCase(0.4f, 95f)]
        public void AWallFadesBeyondItsEdge(float distanceOverSpacing, float degrees)
        {
            FluidSolverSettings settings = BodyRig.Water(Vector3.one, Spacing, 0.3f);
            using (var rig = new BodyRig(settings))
            {
                var corners = new[] { new Vector3(0f, 0f, -0.4f), new Vector3(-0.4f, 0f, 0f), new Vector3(0f, 0f, 0.4f) };
                rig.Add(corners);
                float distance = distanceOverSpacing * Spacing, angle = degrees * Mathf.Deg2Rad;
                Vector3 at = distance * new Vector3(Mathf.Sin(angle), Mathf.Cos(angle), 0f);
                StoredWall wall = Gather(rig, new[] { at })[0];
                Double3[] seen = (degrees < 90f ? corners : corners.Reverse()).Select(p => (Double3)p).ToArray();
                double expected = Share(at, seen, settings);
                Assert.That(expected, Is.GreaterThan(0.0));
                Assert.That(wall.Value, Is.EqualTo(expected).Within(2e-3));
                Assert.That(wall.Flags & 1u, Is.EqualTo(0u), "not a face");
            }
        }

        [Test]
        public void NormalsKeepTheirDirectionAndAxesAreExact()
        {
            FluidSolverSettings settings = BodyRig.Water(Vector3.one, Spacing, 0.3f);
            var random = new System.Random(12);
            for (int i = 0; i < 40; i++)
            {
                Vector3 axis = i < 6 ? Turn((i % 2 == 0 ? 1f : -1f) * Vector3.right, i / 2) : ParticleSets.RandomVector(random).normalized;
                Vector3 u = Vector3.Cross(axis, Mathf.Abs(axis.y) < 0.9f ? Vector3.up : Vector3.right).normalized,
                    v = Vector3.Cross(axis, u);
                using (var rig = new BodyRig(settings))
                {
                    rig.Add(new[] { 0.3f * u, -0.2f * u + 0.3f * v, -0.2f * u - 0.3f * v });
                    StoredWall wall = Gather(rig, new[] { 0.4f * Spacing * axis })[0];
                    Assert.That((wall.Normal - axis).magnitude, Is.LessThan(i < 6 ? 1e-7f : 5e-5f), $"along {axis}");
                }
            }
        }

        [Test]
        public void AStretchedBoxIsABoxOfPlanesWithTheSpeedsOfItsFaces()
        {
            FluidSolverSettings settings = BodyRig.Water(Vector3.one, Spacing, 0.3f);
            using (var rig = new BodyRig(settings))
            {
                Transform box = rig.Add(Box(0.4f * Vector3.one, 3));
                Vector3[] points = Points(251, 0.3f * Vector3.one, 8);
                rig.Start(points.Select((p, i) => new FluidParticle(p, Vector3.zero, (uint)i)).ToArray());
                box.localScale = new Vector3(0.9f, 1.3f, 1.1f);
                rig.Frame(1);
                box.localScale = new Vector3(0.8f, 1.4f, 1.2f);
                rig.UpdateBodies();
                Assert.That(rig.Bodies.HasStretch, Is.True);
                StoredWall[] walls = StoredWall.Gather(rig.State, 0, 1);
                Vector4[] at = GpuTest.Read<Vector4>(rig.State.Buffers.Positions, points.Length);
                uint[] slots = rig.State.List.WallSlot.Read<uint>(points.Length);
                Vector3 size = 0.4f * new Vector3(0.9f, 1.3f, 1.1f); // where the step begins
                Double3[] faces = Inside(size);
                int felt = 0;
                for (int i = 0; i < points.Length; i++)
                {
                    if (slots[i] == 0) continue;
                    Vector3 near = 0.5f * size - new Vector3(Mathf.Abs(at[i].x), Mathf.Abs(at[i].y), Mathf.Abs(at[i].z));
                    if (Mathf.Min(near.x, Mathf.Min(near.y, near.z)) > 0.2f * Spacing)
                    {
                        Assert.That(walls[i].Value, Is.EqualTo(Share(at[i], faces, settings)).Within(1e-3), $"at {at[i]}");
                    }
                    StoredWall wall = walls[i];
                    int axis = Mathf.Abs(wall.Normal.x) > 0.5f ? 0 : Mathf.Abs(wall.Normal.y) > 0.5f ? 1 : 2;
                    float speed = (axis == 0 ? -0.02f : 0.02f) / settings.TimeStep; // half of 0.4 m by 0.1 a step, into the box along x
                    Assert.That(wall.Approach, Is.EqualTo(-speed).Within(1).Percent, $"of axis {axis}");
                    felt++;
                }
                Assert.That(felt, Is.GreaterThan(20));
            }
        }

        // What is square to a face of the domain but for rounding lies before it, not behind it: by 5e-7 x 0.01 m here.
        [Test]
        public void ATouchedFaceOfTheDomainHidesNoWallSquareToIt([Values(-1f, 1f)] float side, [NUnit.Framework.Range(0, 2)] int axis)
        {
            const float slope = 5e-7f, height = 0.01f;
            FluidSolverSettings settings = BodyRig.Water(Vector3.one, Spacing, 0.3f);
            using (var rig = new BodyRig(settings))
            {
                Vector3 At(float x, float z) => Turn(new Vector3(side * x, slope * (x - 0.5f), z), axis);
                rig.Add(new[] { At(0.1f, -0.4f), At(0.1f, 0.4f), At(2f, 0f) });
                StoredWall wall = Gather(rig, new[] { Turn(new Vector3(0.5f * side, height, 0f), axis) })[0];
                double open = (1.0 - StandardReference.Mirror(0.0, settings.SupportRadius, Spacing)) *
                    (1.0 - ShadowReference.Plane(height, settings.SupportRadius, Spacing));
                Assert.That(1.0 - wall.Value, Is.EqualTo(open).Within(2).Percent);
                Assert.That((wall.Normal + side * Turn(Vector3.right, axis)).magnitude, Is.LessThan(1e-6f), "the face is the first plane");
            }
        }

        [Test]
        public void AWallThatTurnsHasTurnedHalfwayAtHalfTheFrame()
        {
            FluidSolverSettings settings = BodyRig.Water(Vector3.one, Spacing, 0.3f);
            settings.Gravity = Vector3.zero;
            var corners = new List<Vector3>();
            Sheet(corners, p => new Vector3(0.6f * p.x - 0.3f, 0f, 0.6f * p.y - 0.3f), 3, false);
            Vector3 normal = Quaternion.Euler(0f, 0f, 30f) * Vector3.up;
            using (var rig = new BodyRig(settings))
            {
                Transform sheet = rig.Add(corners);
                rig.Start(new[] { new FluidParticle(0.02f * normal, Vector3.zero, 0u) });
                rig.Setup();
                sheet.localRotation = Quaternion.Euler(0f, 0f, 60f);
                rig.UpdateBodies();
                StoredWall wall = StoredWall.Gather(rig.State, 1, 2)[0];
                rig.Solver.State.EndBodySteps();
                Assert.That((wall.Normal - normal).magnitude, Is.LessThan(1e-4f), $"{wall.Normal}");
            }
        }

        // Each particle has on its side what it has without the liquid on the other.
        [TestCase(0)]
        [TestCase(1)]
        [TestCase(2)]
        public void LiquidBehindASheetAddsNothing(int axis)
        {
            FluidSolverSettings settings = BodyRig.Water(Vector3.one, Spacing, 0.3f);
            settings.Gravity = Vector3.zero;
            var corners = new List<Vector3>();
            Sheet(corners, p => Turn(new Vector3(0f, p.x - 0.5f, p.y - 0.5f), axis), 4, false);
            FluidParticle[] one = ParticleSets.Lattice(new Vector3Int(4, 5, 6), Spacing, 0.002f, 3);
            for (int i = 0; i < one.Length; i++)
            {
                one[i] = new FluidParticle(Turn(one[i].Position + 2.3f * Spacing * Vector3.right, axis), Vector3.zero, (uint)i);
            }
            FluidParticle[] both = one.Concat(one.Select(p => new FluidParticle(-p.Position, Vector3.zero, p.Id + (uint)one.Length)))
                .ToArray();
            float[] Densities(FluidParticle[] start, out Vector3[] velocities)
            {
                using (var rig = new BodyRig(settings))
                {
                    rig.Add(corners);
                    rig.Start(start);
                    rig.Setup();
                    var byId = new float[start.Length];
                    velocities = new Vector3[start.Length];
                    float[] densities = rig.Densities();
                    FluidParticle[] particles = rig.Particles();
                    for (int i = 0; i < byId.Length; i++) byId[particles[i].Id] = densities[i];
                    rig.Frame(1);
                    foreach (FluidParticle p in rig.Particles()) velocities[p.Id] = p.VelT0;
                    return byId;
                }
            }
            float[] alone = Densities(one, out Vector3[] aloneVelocities), shared = Densities(both, out Vector3[] sharedVelocities);
            float fastest = aloneVelocities.Max(v => v.magnitude);
            Assert.That(fastest, Is.GreaterThan(0f));
            for (int i = 0; i < one.Length; i++)
            {
                Assert.That(shared[i], Is.EqualTo(alone[i]).Within(1e-5).Percent.Or.EqualTo(alone[i]).Within(0.01), $"particle {i}");
                Assert.That((sharedVelocities[i] - aloneVelocities[i]).magnitude, Is.LessThan(1e-4f * fastest), $"particle {i}");
            }
        }

        [Test]
        public void AMovingWallHasItsSpeed()
        {
            FluidSolverSettings settings = BodyRig.Water(Vector3.one, Spacing, 0.3f);
            using (var rig = new BodyRig(settings))
            {
                var corners = new List<Vector3>();
                Sheet(corners, p => new Vector3(0.6f * p.x - 0.3f, 0f, 0.6f * p.y - 0.3f), 3, false);
                Transform sheet = rig.Add(corners);
                Vector3[] points = { new Vector3(0.1f, 0.06f, 0f) };
                rig.Start(points.Select((p, i) => new FluidParticle(p, Vector3.zero, 0u)).ToArray());
                rig.Frame(1);
                sheet.Translate(new Vector3(0.02f, 0.004f, 0f));
                rig.UpdateBodies();
                Assert.That(rig.Bodies.IsUnderWay, Is.True);
                GpuTest.Run(cmd => rig.Solver.RecordSteps(cmd, 4));
                StoredWall wall = StoredWall.Read(rig.State)[0];
                float time = 4f * settings.TimeStep;
                Assert.That(wall.Velocity.x, Is.EqualTo(0.02f / time).Within(0.2).Percent);
                Assert.That(wall.Velocity.y, Is.EqualTo(0.004f / time).Within(0.2).Percent);
                Assert.That(wall.Approach, Is.EqualTo(0.004f / time).Within(0.2).Percent);
                Assert.That(rig.Bodies.IsUnderWay, Is.False, "the motion was stepped through");
            }
        }
    }
}
