using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The detectors of leaks against exact signs and made-up motions.</summary>
    public sealed class LeakDetectorTests
    {
        private static readonly Vector3[] triangle = { Vector3.zero, Vector3.forward, Vector3.right };

        [Test]
        public void APathThroughATriangleIsNeverOverlooked()
        {
            var random = new System.Random(5);
            // On a coarse lattice: many paths touch edges and corners.
            Vector3 At() => new Vector3(random.Next(-4, 5), random.Next(-4, 5), random.Next(-4, 5)) * 0.1f;
            int met = 0;
            for (int i = 0; i < 20000; i++)
            {
                Vector3 a = At(), b = At(), c = At(), p = At(), q = At();
                bool intersects = ExactGeometry.Intersects(p, q, a, b, c);
                met += intersects ? 1 : 0;
                // What lies in the plane but for rounding counts as in it.
                bool inPlane = ExactGeometry.Distance(p, a, b, c) < 1e-6 && ExactGeometry.Distance(q, a, b, c) < 1e-6;
                if (intersects && !inPlane) Assert.That(PathDetector.Intersects(p, q, a, b, c), Is.True, $"{p} to {q}, {a} {b} {c}");
            }
            Assert.That(met, Is.GreaterThan(1000));
        }

        [TestCase(0.2f, true)]
        [TestCase(0.5f, true)]
        [TestCase(0.6f, false)]
        public void APathBesideTheTriangleIsNone(float x, bool intersects)
        {
            var detector = new PathDetector(triangle, Vector3.zero);
            detector.Look(new[] { new Vector3(x, 0.1f, 0.5f) });
            detector.Look(new[] { new Vector3(x, -0.1f, 0.5f) });
            detector.Look(new[] { new Vector3(x, 0.1f, 0.5f) });

            Assert.That(detector.Escapes, Is.EqualTo(intersects ? 1 : 0), "each particle counts once");
        }

        [Test]
        public void APathAcrossAPeriodicFaceGoesOnAtTheOtherSide()
        {
            var detector = new PathDetector(triangle, new Vector3(2f, 0f, 0f));
            detector.Look(new[] { new Vector3(-0.9f, 0.1f, 0.1f), new Vector3(0.9f, 0.1f, 0.1f) });
            detector.Look(new[] { new Vector3(0.95f, -0.1f, 0.1f), new Vector3(-0.9f, -0.1f, 0.1f) });

            Assert.That(detector.Escapes, Is.Zero);
        }

        [Test]
        public void WhatIsNotFiniteEscaped()
        {
            var detector = new PathDetector(triangle, Vector3.zero);
            detector.Look(new[] { Vector3.up });
            detector.Look(new[] { new Vector3(float.NaN, 1f, 1f) });

            Assert.That(detector.Escapes, Is.EqualTo(1));
        }

        [Test]
        public void WhoChangesTheSideOfAClosedSurfaceEscapedEitherWay()
        {
            Vector3[] cup = LeakMeshes.Cup(1f, 2f, 12, true);
            var detector = new InsideDetector(TriangleMesh.FromCorners(cup));
            Vector3 inside = Vector3.up, beside = new Vector3(1.2f, 1f, 0f), above = new Vector3(0f, 2.1f, 0f);
            detector.Look(new[] { inside, inside, beside, beside });
            detector.Look(new[] { 0.5f * inside, above, above, inside });

            Assert.That(detector.Escapes, Is.EqualTo(2));
        }

        [Test]
        public void TheWindingNumberIsThatOfRaysInsideAndOut()
        {
            TriangleMesh mesh = TestMeshes.Sphere(0.5f, 0.01f);
            var winding = new WindingNumber(mesh.Indices.Select(i => mesh.Vertices[i]).ToArray());
            var random = new System.Random(6);
            int inside = 0;
            for (int i = 0; i < 500; i++)
            {
                Vector3 p = 0.7f * ParticleSets.RandomVector(random);
                Assert.That(winding.At(p), Is.EqualTo(mesh.Winding(p)).Within(1e-9));
                inside += mesh.Contains(p) ? 1 : 0;
            }
            Assert.That(inside, Is.GreaterThan(100));
            Assert.That(winding.At(Vector3.zero), Is.EqualTo(1.0).Within(1e-12));
            Assert.That(new WindingNumber(new[] { Vector3.right, Vector3.up, Vector3.forward }).At(Vector3.zero),
                Is.EqualTo(-0.125).Or.EqualTo(0.125).Within(1e-12), "an octant");
        }

        [Test]
        public void RestTellsStuckFromCarriedAndFalling()
        {
            const float dx = 0.02f;
            var scene = new LeakScene
            {
                Settings = LeakSceneEntry.Water(Vector3.one, 0.5f),
                // An upright wall at x = 0 and a level one at y = 0.
                Surface = LeakMeshes.Sheet(new[] { 0f, 0.4f }, new[] { -0.4f, 0.4f }, 0f).SelectMany(p => new[] { p }).Concat(
                    LeakMeshes.Sheet(new[] { 0f, 0.4f }, new[] { -0.4f, 0.4f }, 0f).Select(p => new Vector3(0f, p.x, p.z))).ToArray(),
            };
            Vector3 stuck = new Vector3(0.1f * dx, 0.2f, 0f), falling = new Vector3(0.5f * dx, 0.3f, 0f),
                lying = new Vector3(0.2f, 0.5f * dx, 0f);
            Vector3 carried = lying + dx * Vector3.up, hovering = new Vector3(0.2f, 0.2f, 0f);
            var end = new[] { stuck, falling, lying, carried, hovering };

            WallRest rest = WallRest.Of(scene, LeakPose.Rest, new[] { stuck, falling + dx * Vector3.up, lying, carried, hovering }, end);

            Assert.That(rest.Held, Is.EqualTo(2.0 / 5.0).Within(1e-9), "the stuck and the hovering one");
            Assert.That(rest.FirstLayer, Is.EqualTo((0.1 + 0.5 + 0.5) / 3.0).Within(1e-4));
            Assert.That(rest.Pressed, Is.EqualTo(1.0 / 3.0).Within(1e-9));
        }
    }
}
