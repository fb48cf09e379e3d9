using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>
    /// FindContacts on displacements that the test makes among triangles, against distances to all triangles and their
    /// separating planes in double precision.
    /// </summary>
    public sealed class FindContactsTests
    {
        private const float Carried = 1000f; // what a method takes along
        private const float Spacing = 0.01f;
        private const float Rest = 0.1f * Spacing;
        private const float Longest = 8f * Spacing;
        private const int Shortened = 3; // COUNTER_SHORTENED

        private FluidShaderSet shaders;

        [SetUp]
        public void SetUp() => shaders = TestShaders.CreateSet();

        [TearDown]
        public void TearDown() => Object.DestroyImmediate(shaders);

        [Test]
        public void WhatComesToATriangleIsListedAndWhatPassesIsCounted(
            [Values(1, 63, 64, 65, 257, 1009)] int count, [Values(0, 1, 2)] int kind)
        {
            FluidSolverSettings settings = StandardStateRig.Water(0.6f * Vector3.one, Spacing);
            var random = new System.Random(kind);
            List<Vector3> corners = ContactShotTests.Scene(kind, Vector3.zero, random);
            using (var rig = new StandardStateRig(settings, count))
            using (CollisionBodies bodies = Bodies(settings, corners))
            {
                rig.State.Bodies = bodies;
                FluidParticle[] all = Starts(corners, count, random, out Dictionary<uint, Vector3> ends);
                FluidParticle[] from = rig.FillSorted(all);
                Vector3[] to = from.Select(p => ends[p.Id]).ToArray();
                var listed = new HashSet<int>(Find(rig, to));
                int near = 0, clear = 0;
                for (int i = 0; i < count; i++)
                {
                    bool isNear = IsNearer(from[i].Position, to[i], corners, 0.999 * Rest);
                    bool isClear = !isNear && PassesAll(from[i].Position, to[i], corners);
                    near += isNear ? 1 : 0;
                    clear += isClear ? 1 : 0;
                    if (isNear || isClear) Assert.That(listed.Contains(i), Is.EqualTo(isNear), $"whether {i} is listed");
                }

                if (count > 1) Assert.That(Math.Min(near, clear), Is.GreaterThan(count / 10), $"{near} near, {clear} clear");
                Vector4[] places = GpuTest.Read<Vector4>(rig.State.Buffers.NewPositions, count);
                Assert.That(places.Select(p => (Vector3)p), Is.EqualTo(to), "places stay");
                StandardStateRig.AssertCounted(rig.State, places, Enumerable.Range(0, count).Except(listed).ToArray());
            }
        }

        // Every second goes farther than contact follows.
        [TestCase(1)]
        [TestCase(65)]
        public void LongerDisplacementsAreShortenedAndCounted(int count)
        {
            FluidSolverSettings settings = StandardStateRig.Water(2f * Vector3.one, Spacing);
            using (var rig = new StandardStateRig(settings, count))
            using (CollisionBodies bodies = Bodies(settings, FarTriangle))
            {
                rig.State.Bodies = bodies;
                var random = new System.Random(count);
                FluidParticle[] from = rig.FillSorted(ParticleSets.Random(count, Vector3.one, 0f, count));
                Vector3[] along = from.Select(_ => ParticleSets.RandomVector(random).normalized).ToArray();
                Vector3 End(int i, float longest) =>
                    from[i].Position + (i % 2 == 0 ? longest : 0.99f) * Longest * along[i];
                int[] listed = Find(rig, Enumerable.Range(0, count).Select(i => End(i, 1.5f)).ToArray());
                Vector4[] places = GpuTest.Read<Vector4>(rig.State.Buffers.NewPositions, count);
                Assert.That(listed, Is.Empty);
                Assert.That(places.Select(p => p.w), Is.All.EqualTo(Carried));
                for (int i = 0; i < count; i++)
                {
                    Assert.That(((Vector3)places[i] - End(i, 1f)).magnitude, Is.LessThan(1e-6f), $"particle {i}");
                }
                Assert.That(rig.Counters()[Shortened], Is.EqualTo((uint)(count + 1) / 2u));
                StandardStateRig.AssertCounted(rig.State, places, Enumerable.Range(0, count).ToArray());
            }
        }

        // Straight through the triangles, but not of the liquid any more.
        [Test]
        public void ParticlesThatLeftTheDomainAreNeitherListedNorCounted()
        {
            const int count = 130;
            FluidSolverSettings settings = StandardStateRig.Water(0.6f * Vector3.one, Spacing);
            var random = new System.Random(1);
            List<Vector3> corners = ContactShotTests.Scene(0, Vector3.zero, random);
            using (var rig = new StandardStateRig(settings, count))
            using (CollisionBodies bodies = Bodies(settings, corners))
            {
                rig.State.Bodies = bodies;
                FluidParticle[] all = Starts(corners, count, random, out Dictionary<uint, Vector3> ends);
                for (int i = 0; i < count; i += 2) all[i].Removed = 1f;
                FluidParticle[] from = rig.FillSorted(all);
                int[] listed = Find(rig, from.Select(p => ends[p.Id]).ToArray());
                Assert.That(listed, Is.Not.Empty.And.All.LessThan(count / 2));
                Vector4[] places = GpuTest.Read<Vector4>(rig.State.Buffers.NewPositions, count);
                int[] counted = Enumerable.Range(0, count / 2).Except(listed).ToArray();
                StandardStateRig.AssertCounted(rig.State, places, counted);
            }
        }

        // Across the face it is a tenth of dx, not the length of the domain.
        [Test]
        public void ThroughAPeriodicFaceADisplacementIsShort()
        {
            FluidSolverSettings settings = StandardStateRig.Water(2f * Vector3.one, Spacing, FluidAxes.X);
            using (var rig = new StandardStateRig(settings, 1))
            using (CollisionBodies bodies = Bodies(settings, FarTriangle))
            {
                rig.State.Bodies = bodies;
                rig.FillSorted(new[] { new FluidParticle(new Vector3(0.9995f, 0f, 0f), Vector3.zero, 0u) });
                var to = new Vector3(-0.9995f, 0f, 0f);
                Assert.That(Find(rig, new[] { to }), Is.Empty);
                Assert.That((Vector3)GpuTest.Read<Vector4>(rig.State.Buffers.NewPositions, 1)[0], Is.EqualTo(to));
                Assert.That(rig.Counters()[Shortened], Is.Zero);
            }
        }

        // What GatherWalls said of the distance is trusted, so a triangle across the path is found only where the gap is used up: by how
        // far the particle is from where that was said, here a displacement back, at both ends of its step.
        [TestCase(0.5f, 0f)]
        [TestCase(1.05f, 0f)]
        [TestCase(1.3f, 0f)]
        [TestCase(1.9f, 1f)]
        [TestCase(2.3f, 1f)]
        [TestCase(1.3f, -1f)]
        public void WithinTheGapNothingIsLookedUp(float gapOverDisplacement, float backOverDisplacement)
        {
            FluidSolverSettings settings = StandardStateRig.Water(2f * Vector3.one, Spacing);
            using (var rig = new StandardStateRig(settings, 1))
            using (CollisionBodies bodies = Bodies(settings, AcrossTriangle))
            {
                rig.State.Bodies = bodies;
                const float displacement = 0.5f * Spacing;
                rig.FillSorted(new[] { new FluidParticle(Vector3.zero, Vector3.zero, 0u) });
                float gone = Mathf.Max(Mathf.Abs(backOverDisplacement), Mathf.Abs(1f + backOverDisplacement)) * displacement;
                float gap = gapOverDisplacement * displacement;
                bool free = gap > gone + 1.02f * Rest;
                Assert.That(Find(rig, new[] { displacement * Vector3.up }, gap, backOverDisplacement * displacement * Vector3.down).Length,
                    Is.EqualTo(free ? 0 : 1));
            }
        }

        // The place where the gap was said is then a domain away.
        [Test]
        public void ThroughAPeriodicFaceTheGapIsLost()
        {
            FluidSolverSettings settings = StandardStateRig.Water(2f * Vector3.one, Spacing, FluidAxes.X);
            using (var rig = new StandardStateRig(settings, 1))
            using (CollisionBodies bodies = Bodies(settings, AcrossTriangle.Select(p => p + Vector3.left).ToList()))
            {
                rig.State.Bodies = bodies;
                var from = new Vector3(-1f, 0f, 0f);
                rig.FillSorted(new[] { new FluidParticle(from, Vector3.zero, 0u) });
                Vector3 to = from + 0.5f * Spacing * Vector3.up;
                Assert.That(Find(rig, new[] { to }, Spacing, from), Is.Empty);
                rig.FillSorted(new[] { new FluidParticle(from, Vector3.zero, 0u) });
                Assert.That(Find(rig, new[] { to }, Spacing, -from).Length, Is.EqualTo(1));
            }
        }

        private static List<Vector3> AcrossTriangle => new List<Vector3>
        {
            new Vector3(-0.1f, 0.2f * Spacing, -0.1f), new Vector3(0.1f, 0.2f * Spacing, -0.1f), new Vector3(0f, 0.2f * Spacing, 0.2f),
        };

        private static List<Vector3> FarTriangle => new List<Vector3>
        {
            new Vector3(0f, -0.9f, 0f), new Vector3(0.01f, -0.9f, 0f), new Vector3(0f, -0.9f, 0.01f),
        };

        // Runs the pass and returns the list, its arguments checked. gapAt: from where nothing is nearer than the gap.
        private int[] Find(StandardStateRig rig, Vector3[] to, float gap = 0f, Vector3 gapAt = default)
        {
            StandardState state = rig.State;
            state.RequireWalls();
            state.Buffers.NewPositions.SetData(to.Select(p => StandardStateRig.WithW(p, Carried)).ToArray());
            StandardStateRig.EmptyContacts(state);
            state.Walls.WallGap.SetData(Enumerable.Repeat(new Vector4(gapAt.x, gapAt.y, gapAt.z, gap), state.ParticleCount).ToArray());
            var pass = new FindContactsPass(shaders);
            GpuTest.Run(cmd => pass.Record(cmd, state, new FluidStep(1e-3f, 1e-3f, false), state.Buffers.PositionTerms));
            uint[] arguments = GpuTest.Read<uint>(state.Walls.Contacts, 4);
            uint listed = arguments[3];
            uint groups = (listed + 63u) / 64u;
            Assert.That(arguments, Is.EqualTo(new[] { groups, 1u, 1u, listed }), "groups that resolve them, number");
            uint[] contacts = GpuTest.Read<uint>(state.Walls.Contacts, 4 + 4 * (int)listed);
            int[] list = Enumerable.Range(1, (int)listed).Select(i => (int)contacts[4 * i + 3]).ToArray();
            Vector4[] from = GpuTest.Read<Vector4>(state.Buffers.PositionTerms, state.ParticleCount);
            for (int i = 0; i < list.Length; i++)
            {
                var began = new Vector3(BitConverter.Int32BitsToSingle((int)contacts[4 * i + 4]),
                    BitConverter.Int32BitsToSingle((int)contacts[4 * i + 5]), BitConverter.Int32BitsToSingle((int)contacts[4 * i + 6]));
                Assert.That(began, Is.EqualTo((Vector3)from[list[i]]), "where it began");
            }
            Assert.That(list.Distinct().Count(), Is.EqualTo(list.Length), "each is listed once");
            return list;
        }

        private static CollisionBodies Bodies(in FluidSolverSettings settings, List<Vector3> corners)
        {
            var bodies = new CollisionBodies(settings);
            using (var colliders = new ColliderRig { DomainSize = settings.DomainSize, Spacing = settings.Spacing })
            {
                colliders.AddMesh(new Mesh
                {
                    name = "Test Triangles",
                    indexFormat = UnityEngine.Rendering.IndexFormat.UInt32,
                    vertices = corners.ToArray(),
                    triangles = Enumerable.Range(0, corners.Count).ToArray(),
                });
                colliders.Gather();
                bodies.Update(colliders.Scene.Solids);
            }

            return bodies;
        }

        // Every second is shot at a triangle, the others go anywhere.
        private static FluidParticle[] Starts(
            List<Vector3> corners, int count, System.Random random, out Dictionary<uint, Vector3> ends)
        {
            ends = new Dictionary<uint, Vector3>();
            FluidParticle[] particles = ParticleSets.Random(count, 0.4f * Vector3.one, 0f, count);
            for (int i = 0; i < count; i++)
            {
                Vector3 to = particles[i].Position + 2f * Spacing * ParticleSets.RandomVector(random);
                if (i % 2 == 0)
                {
                    ContactShotTests.Shoot(corners, random, out Vector4 p, out Vector4 q);
                    particles[i].Position = p;
                    to = (Vector3)p + Vector3.ClampMagnitude((Vector3)q - (Vector3)p, 0.99f * Longest);
                }

                ends[(uint)i] = to;
            }

            return particles;
        }

        // Whether plane or box keeps each triangle a hundredth more than the contact distance off.
        private static bool PassesAll(Vector3 from, Vector3 to, List<Vector3> corners)
        {
            const double margin = 1.01 * Rest;
            for (int t = 0; t < corners.Count; t += 3)
            {
                if (IsBoxApart(from, to, corners, t, margin)) continue;
                Double3 a = corners[t], ab = (Double3)corners[t + 1] - a, ac = (Double3)corners[t + 2] - a;
                Double3 n = Double3.Cross(ab, ac);
                double length = n.Length;
                if (length < 1e-3 * ab.Length * ac.Length) return false; // a needle, whose plane float may not know
                double s0 = Double3.Dot(from - a, n) / length, s1 = Double3.Dot(to - a, n) / length;
                if (Math.Min(s0, s1) <= margin && Math.Max(s0, s1) >= -margin) return false;
            }

            return true;
        }

        private static bool IsBoxApart(Vector3 from, Vector3 to, List<Vector3> corners, int t, double margin)
        {
            for (int axis = 0; axis < 3; axis++)
            {
                double a = corners[t][axis], b = corners[t + 1][axis], c = corners[t + 2][axis];
                double low = Math.Min(a, Math.Min(b, c)) - margin, high = Math.Max(a, Math.Max(b, c)) + margin;
                if (Math.Max(from[axis], to[axis]) < low || Math.Min(from[axis], to[axis]) > high) return true;
            }

            return false;
        }

        // Whether a displacement comes nearer to a triangle: an end to its face, or a point of it to an edge.
        private static bool IsNearer(Vector3 from, Vector3 to, List<Vector3> corners, double distance)
        {
            for (int t = 0; t < corners.Count; t += 3)
            {
                if (IsBoxApart(from, to, corners, t, distance)) continue;
                Vector3 a = corners[t], b = corners[t + 1], c = corners[t + 2];
                if (ExactGeometry.Intersects(from, to, a, b, c)) return true;
                double ends = Math.Min(ExactGeometry.Distance(from, a, b, c), ExactGeometry.Distance(to, a, b, c));
                double edges = Math.Min(Between(from, to, a, b), Between(from, to, b, c));
                if (Math.Min(ends, Math.Min(edges, Between(from, to, c, a))) < distance) return true;
            }

            return false;
        }

        // Of two segments: the distance to the second is convex along the first.
        private static double Between(Double3 p, Double3 q, Double3 a, Double3 b)
        {
            Double3 edge = b - a;
            double squared = Double3.Dot(edge, edge);
            double Reach(double t)
            {
                Double3 x = p + t * (q - p);
                double u = squared > 0.0 ? Math.Max(0.0, Math.Min(1.0, Double3.Dot(x - a, edge) / squared)) : 0.0;
                return (x - a - u * edge).Length;
            }

            double low = 0.0, high = 1.0;
            for (int i = 0; i < 50; i++)
            {
                double third = (high - low) / 3.0;
                if (Reach(low + third) < Reach(high - third)) high -= third;
                else low += third;
            }

            return Reach(0.5 * (low + high));
        }
    }
}
