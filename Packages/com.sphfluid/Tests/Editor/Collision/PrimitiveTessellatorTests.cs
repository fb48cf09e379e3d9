using System;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Box, sphere, capsule and cylinder become closed outward meshes near enough to the true surface.</summary>
    public sealed class PrimitiveTessellatorTests
    {
        [Test]
        public void BoxIsClosedOutwardAndExact()
        {
            TriangleMesh box =
                PrimitiveTessellator.Box(Matrix4x4.TRS(new Vector3(1f, 2f, 3f), Quaternion.Euler(10f, 20f, 30f), new Vector3(2f, 3f, 4f)));
            Assert.That(box.TriangleCount, Is.EqualTo(12));
            Assert.That(IsFoundClosed(box));
            Assert.That(TestMeshes.Volume(box), Is.EqualTo(24.0).Within(1e-3));
        }

        [Test]
        public void MirroredBoxStaysOutward() =>
            Assert.That(TestMeshes.Volume(PrimitiveTessellator.Box(Matrix4x4.Scale(new Vector3(-1f, 2f, 1f)))),
                Is.EqualTo(2.0).Within(1e-5));

        [TestCase(0.5f, 0.01f)]
        [TestCase(0.5f, 0.002f)]
        [TestCase(0.02f, 0.01f)]
        public void SphereKeepsTheChordError(float radius, float chordError)
        {
            TriangleMesh sphere = TestMeshes.Sphere(radius, chordError);
            Assert.That(IsFoundClosed(sphere));
            Assert.That(TestMeshes.Volume(sphere), Is.Positive);
            Assert.That(LargestDepth(sphere, p => radius - p.magnitude), Is.LessThanOrEqualTo(chordError * 1.0001f));
        }

        [Test]
        public void CapsuleKeepsTheChordErrorAndItsLength()
        {
            const float radius = 0.3f, halfLength = 0.5f;
            TriangleMesh capsule = PrimitiveTessellator.Capsule(Matrix4x4.identity, radius, halfLength, 0.005f);
            Assert.That(IsFoundClosed(capsule));
            double volume = Math.PI * radius * radius * (2.0 * halfLength + 4.0 / 3.0 * radius);
            Assert.That(TestMeshes.Volume(capsule), Is.EqualTo(volume).Within(4).Percent.And.LessThan(volume));
            Assert.That(LargestDepth(capsule, p => radius - (p - new Vector3(0f, Mathf.Clamp(p.y, -halfLength, halfLength), 0f)).magnitude),
                Is.LessThanOrEqualTo(0.0050005f));
        }

        [Test]
        public void CylinderKeepsTheChordErrorAndItsLength()
        {
            const float radius = 0.3f, halfLength = 0.1f;
            TriangleMesh cylinder = PrimitiveTessellator.Cylinder(Matrix4x4.identity, radius, halfLength, 0.005f);
            Assert.That(IsFoundClosed(cylinder));
            double volume = Math.PI * radius * radius * 2.0 * halfLength;
            Assert.That(TestMeshes.Volume(cylinder), Is.EqualTo(volume).Within(2).Percent.And.LessThan(volume));
            Assert.That(LargestDepth(cylinder, p => Math.Min(halfLength - Math.Abs(p.y), radius - new Vector2(p.x, p.z).magnitude)),
                Is.LessThanOrEqualTo(0.0050005f));
        }

        [Test]
        public void SegmentsAreCapped()
        {
            Assert.That(PrimitiveTessellator.Segments(1f, 1e-9f), Is.EqualTo(PrimitiveTessellator.MaxSegments));
            Assert.That(PrimitiveTessellator.Segments(1f, 10f), Is.EqualTo(6));
        }

        private static bool IsFoundClosed(TriangleMesh mesh) => new TriangleMesh(mesh.Vertices, mesh.Indices).IsClosed;

        // Largest distance inside the true surface over a grid of points on each triangle.
        private static float LargestDepth(TriangleMesh mesh, Func<Vector3, float> depth)
        {
            float largest = 0f;
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out Vector3 a, out Vector3 b, out Vector3 c);
                for (int i = 0; i <= 6; i++)
                    for (int j = 0; i + j <= 6; j++) largest = Mathf.Max(largest, depth(a + (b - a) * (i / 6f) + (c - a) * (j / 6f)));
            }
            return largest;
        }
    }
}
