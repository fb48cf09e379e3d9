using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// What walls add is one function of place, whose gradient is their push: walls that stand still do no work, however they are cut.
    /// </summary>
    public sealed class WallEnergyTests
    {
        private const float Spacing = 0.05f, Radius = 5.3f * Spacing, Height = 0.6f;

        public enum Cut { OneWay, TheOther, Alternate, Turned }

        private static readonly FluidSolverSettings Settings = BodyRig.Water(1.2f * Vector3.one, Spacing, 0.3f);

        // An upright tube without a floor, of quads that are cut in two; some of the triangles run the other way round with Turned.
        private static List<Vector3> Tube(int sides, Cut cut, int rows = 4)
        {
            var corners = new List<Vector3>();
            Vector3 At(int side, int row) =>
                new Vector3(Radius * Mathf.Cos(2f * Mathf.PI * (side % sides) / sides), Height * ((float)row / rows - 0.5f),
                    Radius * Mathf.Sin(2f * Mathf.PI * (side % sides) / sides));
            for (int row = 0; row < rows; row++)
                for (int side = 0; side < sides; side++)
                {
                    Vector3 a = At(side, row), b = At(side + 1, row), c = At(side, row + 1), d = At(side + 1, row + 1);
                    bool other = cut == Cut.TheOther || cut == Cut.Alternate && (side + row) % 2 == 0;
                    Vector3[] two = other ? new[] { a, b, d, a, d, c } : new[] { a, b, c, b, d, c };
                    if (cut == Cut.Turned && (3 * side + row) % 5 < 2) (two[1], two[2]) = (two[2], two[1]);
                    corners.AddRange(two);
                }
            return corners;
        }

        // A closed ball of few facets, seen from outside.
        private static List<Vector3> Rock()
        {
            var corners = new List<Vector3>();
            Vector3 At(int ring, int step)
            {
                float polar = Mathf.PI * ring / 8f, turn = 2f * Mathf.PI * (step % 10) / 10f,
                    size = 3.5f * Spacing * (1f + 0.2f * Mathf.Sin(3f * turn) * Mathf.Sin(2f * polar));
                return size * new Vector3(Mathf.Sin(polar) * Mathf.Cos(turn), Mathf.Cos(polar), Mathf.Sin(polar) * Mathf.Sin(turn));
            }
            for (int ring = 0; ring < 8; ring++)
                for (int step = 0; step < 10; step++)
                {
                    Vector3 a = At(ring, step), b = At(ring, step + 1), c = At(ring + 1, step), d = At(ring + 1, step + 1);
                    if (ring > 0) corners.AddRange(new[] { a, b, c });
                    if (ring < 7) corners.AddRange(new[] { b, d, c });
                }
            return corners;
        }

        internal static StoredWall[] Gather(List<Vector3> corners, Vector3[] points)
        {
            using (StandardStateRig rig = WalledStateRig.Create(Settings, corners.ToArray(), points.Length, out CollisionBodies bodies))
            using (bodies)
            {
                FluidParticle[] sorted = rig.FillSorted(points.Select((p, i) => new FluidParticle(p, Vector3.zero, (uint)i)).ToArray());
                GpuTest.Run(cmd => new GatherWallsPass(rig.Shaders).Record(cmd, rig.State, rig.State.Buffers.Positions));
                StoredWall[] walls = StoredWall.Read(rig.State), result = new StoredWall[points.Length];
                for (int i = 0; i < points.Length; i++) result[sorted[i].Id] = walls[i];
                return result;
            }
        }

        private static Vector3[] InTube(int count) =>
            ParticleSets.Random(4 * count, new Vector3(2f * Radius, 0.5f * Height, 2f * Radius), 0f, 7).Select(p => p.Position)
                .Where(p => Math.Abs(Mathf.Sqrt(p.x * p.x + p.z * p.z) - Radius + 0.7f * Spacing) < 0.35f * Spacing).Take(count).ToArray();

        [Test]
        public void ItDoesNotMatterHowASurfaceIsCut([Values(12, 32, 64)] int sides)
        {
            Vector3[] points = InTube(200);
            Assert.That(points, Has.Length.GreaterThan(100));
            StoredWall[] one = Gather(Tube(sides, Cut.OneWay), points);
            foreach (StoredWall[] other in new[] { Cut.TheOther, Cut.Alternate, Cut.Turned }.Select(cut => Gather(Tube(sides, cut), points))
                .Append(Gather(Tube(sides, Cut.OneWay, 7), points)))
                for (int i = 0; i < points.Length; i++)
                {
                    Assert.That(other[i].Value, Is.EqualTo(one[i].Value).Within(1e-3), $"at {points[i]}");
                    Assert.That((other[i].Push - one[i].Push).Length, Is.LessThan(0.02 / Spacing), $"at {points[i]}");
                }
            Assert.That(one.Max(w => w.Value), Is.GreaterThan(0.1));
        }

        [Test]
        public void RoundATubeTheyDoNoWork([Values(12, 32, 64)] int sides, [Values] Cut cut)
        {
            const int points = 1920;
            float radius = Radius * Mathf.Cos(Mathf.PI / sides) - 0.5f * Spacing;
            Vector3[] ring = Enumerable.Range(0, points).Select(i => 2f * Mathf.PI * (i + 0.5f) / points)
                .Select(a => new Vector3(radius * Mathf.Cos(a), 0.013f, radius * Mathf.Sin(a))).ToArray();
            StoredWall[] walls = Gather(Tube(sides, cut), ring);
            double work = 0.0;
            for (int i = 0; i < points; i++)
            {
                work += 2.0 * Math.PI / points * Double3.Dot(walls[i].Push, new Double3(-ring[i].z, 0.0, ring[i].x));
            }
            Assert.That(Math.Abs(work), Is.LessThan(1e-3), "over what touches the whole kernel");
        }

        [TestCase(false, 1e-3)]
        [TestCase(true, 3e-3)]
        public void RoundSmallLoopsTheyDoNoWork(bool outside, double most)
        {
            const int loops = 60, points = 64;
            var random = new System.Random(3);
            Vector3[] middles = outside
                ? Enumerable.Range(0, loops).Select(_ => (3.5f + 1.1f) * Spacing * ParticleSets.RandomVector(random).normalized).ToArray()
                : InTube(loops);
            var places = new List<Vector3>();
            var steps = new List<Vector3>();
            foreach (Vector3 middle in middles)
            {
                Vector3 u = ParticleSets.RandomVector(random).normalized,
                    v = Vector3.Cross(u, ParticleSets.RandomVector(random)).normalized;
                for (int i = 0; i < points; i++)
                {
                    float a = 2f * Mathf.PI * (i + 0.5f) / points, radius = 0.15f * Spacing;
                    places.Add(middle + radius * (Mathf.Cos(a) * u + Mathf.Sin(a) * v));
                    steps.Add(2f * Mathf.PI / points * radius * (-Mathf.Sin(a) * u + Mathf.Cos(a) * v));
                }
            }
            StoredWall[] walls = Gather(outside ? Rock() : Tube(24, Cut.OneWay), places.ToArray());
            double squares = 0.0;
            int felt = 0;
            for (int loop = 0; loop < middles.Length; loop++)
            {
                double work = 0.0, size = 0.0;
                for (int i = loop * points; i < (loop + 1) * points; i++)
                {
                    work += Double3.Dot(walls[i].Push, (Double3)steps[i]);
                    size += walls[i].Push.Length * steps[i].magnitude;
                }
                if (size < 1e-4) continue;
                felt++;
                squares += work * work / (size * size);
            }
            double mean = Math.Sqrt(squares / felt);
            TestContext.WriteLine($"{mean:e1} of the length times the push, in {felt} loops");
            Assert.That(felt, Is.GreaterThan(20));
            Assert.That(mean, Is.LessThan(most));
        }

        // A plate, and beside it a sheet of its own that runs the other way round and is nearer: each is seen from its own side.
        [Test]
        public void ASurfaceThatIsNearerTurnsNoOther([Values] bool sheetFirst)
        {
            Vector3 At(float x, float y, float z) => Spacing * new Vector3(x, y, z);
            TriangleMesh box = TriangleMesh.Box(Matrix4x4.TRS(At(4.1f, 0.25f, 0f), Quaternion.identity, At(8f, 0.3f, 8f)));
            Vector3[] plate = box.Indices.Select(i => box.Vertices[i]).ToArray();
            Vector3[] sheet = { At(-4f, 0.5f, -3f), At(0f, 0.5f, -3f), At(-4f, 0.5f, 5f) };
            var point = At(-0.1f, 1f, 0f);
            double Share(IEnumerable<Vector3> corners) =>
                ShadowReference.Share(point, corners.Select(c => (Double3)c).ToArray(), Settings.SupportRadius, Spacing);
            double expected = Share(plate) + Share(sheet.Reverse());
            Assert.That(Share(sheet), Is.Zero, "it looks down");
            Assert.That(Share(plate), Is.GreaterThan(0.02));
            StoredWall wall = Gather((sheetFirst ? sheet.Concat(plate) : plate.Concat(sheet)).ToList(), new[] { point })[0];
            Assert.That(wall.Value, Is.EqualTo(expected).Within(1e-3));
        }

        private static IEnumerable<Vector3> Box(Vector3 low, Vector3 high)
        {
            TriangleMesh box = TriangleMesh.Box(Matrix4x4.TRS(0.5f * Spacing * (low + high), Quaternion.identity, Spacing * (high - low)));
            return box.Indices.Select(i => box.Vertices[i]);
        }

        private static readonly Vector3 Low = new Vector3(-6f, -6f, -6f), High = new Vector3(6f, 0f, 6f), Tall = new Vector3(0f, 6f, 6f);

        // What is behind a floor is hidden by it, be it a floor further down or the foot of a wall; what stands beside it is not.
        [Test]
        public void WhatOverlapsCountsOnce()
        {
            Vector3[] over = Enumerable.Range(0, 12).Select(i => Spacing * new Vector3(1.2f + 0.2f * i, 0.15f + 0.08f * i, 0.3f)).ToArray();
            Vector3 down = 0.3f * Vector3.up;
            StoredWall[] floor = Gather(Box(Low, High).ToList(), over),
                floors = Gather(Box(Low, High).Concat(Box(Low, High - down)).ToList(), over),
                corner = Gather(Box(Low, High).Concat(Box(Low, Tall)).ToList(), over),
                all = Gather(Box(Low, High).Concat(Box(Low, High - down)).Concat(Box(Low, Tall)).ToList(), over),
                tiles = Gather(Box(Low, new Vector3(1.5f, 0f, 6f)).Concat(Box(new Vector3(1.5f, -6f, -6f), High)).ToList(), over);
            double Plane(double d) => ShadowReference.Plane(d, Settings.SupportRadius, Spacing);
            for (int i = 0; i < over.Length; i++)
            {
                double own = Plane(over[i].y), side = Plane(over[i].x);
                Assert.That(floors[i].Value, Is.EqualTo(floor[i].Value).Within(2e-3), $"at {over[i]}");
                Assert.That((floors[i].Push - floor[i].Push).Length, Is.LessThan(0.02 / Spacing), $"at {over[i]}");
                Assert.That(corner[i].Value, Is.EqualTo(own + side - own * side).Within(5e-3), $"at {over[i]}");
                Assert.That(all[i].Value, Is.EqualTo(corner[i].Value).Within(2e-3), $"at {over[i]}");
                Assert.That(tiles[i].Value, Is.EqualTo(floor[i].Value).Within(5e-3), $"at {over[i]}");
            }
        }

        // What is seen edge-on hides next to nothing: where a particle crosses the plane of a triangle beside it, and sees the other side
        // from then on or, of a solid, the back, nothing comes or goes at once. By sums over the edges alone up to 0.08 did.
        [Test]
        public void BesideATriangleNextToNothingOfItIsSeenFromItsPlane()
        {
            const float height = 1e-3f * Spacing;
            var random = new System.Random(9);
            double largest = 0.0;
            int near = 0;
            for (int sample = 0; sample < 6; sample++)
            {
                Vector3[] corners = Enumerable.Range(0, 3)
                    .Select(_ => (0.7f + 0.4f * sample) * Spacing * ParticleSets.RandomVector(random)).ToArray();
                Vector3 normal = Vector3.Cross(corners[1] - corners[0], corners[2] - corners[0]).normalized;
                Vector3[] points = Enumerable.Range(0, 64).Select(i =>
                {
                    Vector3 from = corners[i % 3], edge = corners[(i + 1) % 3] - from;
                    return from + (float)random.NextDouble() * edge +
                        (0.02f + 0.5f * (float)random.NextDouble()) * Spacing * Vector3.Cross(edge, normal).normalized + height * normal;
                }).ToArray();
                StoredWall[] walls = Gather(corners.ToList(), points);
                Double3[] triangle = corners.Select(c => (Double3)c).ToArray();
                for (int i = 0; i < points.Length; i++)
                {
                    largest = Math.Max(largest,
                        Math.Abs(walls[i].Value - ShadowReference.Share(points[i], triangle, Settings.SupportRadius, Spacing)));
                    near += walls[i].Push.Length * Spacing > 1e-3 ? 1 : 0;
                }
            }
            TestContext.WriteLine($"within {largest:e1}, {near} near");
            Assert.That(near, Is.GreaterThan(100));
            Assert.That(largest, Is.LessThan(5e-4));
        }

        // As any modelling program writes a glass. It spun by 9 to 20 rad/s.
        [Test]
        public void StillWaterInAGlassStaysStill([Values(Cut.OneWay, Cut.TheOther)] Cut cut)
        {
            FluidSolverSettings settings = BodyRig.Water(new Vector3(0.7f, 0.6f, 0.7f), Spacing, 0.2f);
            using (var rig = new BodyRig(settings))
            {
                rig.Add(Tube(32, cut));
                FluidParticle[] water = ParticleSets.Lattice(new Vector3Int(12, 4, 12), Spacing, 0.02f * Spacing, 3)
                    .Select(p => new FluidParticle(p.Position + new Vector3(0f, -0.2f, 0f), Vector3.zero, p.Id))
                    .Where(p => p.Position.x * p.Position.x +
                        p.Position.z * p.Position.z < (Radius - 0.5f * Spacing) * (Radius - 0.5f * Spacing))
                        .Select((p, i) => new FluidParticle(p.Position, Vector3.zero, (uint)i)).ToArray();
                rig.Start(water);
                int steps = Mathf.CeilToInt(1f / settings.TimeStep);
                for (int frame = 0; frame < steps / 8; frame++) rig.Frame(8);
                FluidParticle[] now = rig.Particles();
                double spin = now.Sum(p => (double)(p.Position.z * p.VelT0.x - p.Position.x * p.VelT0.z)) /
                    now.Sum(p => (double)(p.Position.x * p.Position.x + p.Position.z * p.Position.z));
                TestContext.WriteLine($"{now.Length} particles, {spin:f4} rad/s after {steps} steps");
                Assert.That(Math.Abs(spin), Is.LessThan(0.1));
            }
        }
    }
}
