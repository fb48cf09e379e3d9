using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Spheres and meshes hold as many particles as their volume, inside, with their velocity.</summary>
    public sealed class LiquidShapeTests
    {
        private const float Spacing = 0.04f;

        [TestCase(0.8f, 0.8f, 0.8f, 0f)]
        [TestCase(0.9f, 0.6f, 0.75f, 0f)]
        [TestCase(0.9f, 0.6f, 0.75f, 33f)]
        public void AnEllipsoidHoldsItsVolume(float x, float y, float z, float angle)
        {
            Matrix4x4 frame = Matrix4x4.TRS(new Vector3(0.11f, -0.07f, 0.03f), Quaternion.Euler(angle, 2f * angle, 0f),
                new Vector3(x, y, z));
            var velocity = new Vector3(1f, 2f, 3f);
            SpawnResult result = Fill(new LiquidEllipsoid("drop", frame, velocity));
            Assert.That(result.Particles.Count, Is.EqualTo(Math.PI / 6.0 * x * y * z / Math.Pow(Spacing, 3)).Within(2).Percent);
            Assert.That(result.Tallies[0].Expected, Is.EqualTo(Math.PI / 6.0 * x * y * z / Math.Pow(Spacing, 3)).Within(0.01).Percent);
            Matrix4x4 back = frame.inverse;
            Assert.That(result.Particles.Max(p => back.MultiplyPoint3x4(p.Position).magnitude), Is.LessThan(0.50001f));
            Assert.That(result.Particles.All(p => p.VelT0 == velocity));
        }

        [Test]
        public void AMeshHoldsItsVolumeWhetherItsFacesLookInOrOut([Values] bool inward)
        {
            TriangleMesh ball = TestMeshes.Sphere(0.4f, 1e-3f).Transformed(Matrix4x4.Translate(new Vector3(0.2f, 0.1f, 0f)));
            if (inward) ball = new TriangleMesh(ball.Vertices, ball.Indices.Reverse().ToArray());
            SpawnResult result = Fill(new LiquidMesh("ball", ball, Vector3.zero));
            double volume = Math.Abs(TestMeshes.Volume(ball));
            Assert.That(result.Tallies[0].Expected, Is.EqualTo(volume / Math.Pow(Spacing, 3)).Within(0.01).Percent);
            Assert.That(result.Particles.Count, Is.EqualTo(volume / Math.Pow(Spacing, 3)).Within(2).Percent);
            Assert.That(result.Particles.Max(p => (p.Position - new Vector3(0.2f, 0.1f, 0f)).magnitude), Is.LessThan(0.4f));
        }

        [Test]
        public void ACubeOfTrianglesIsFilledAsABox()
        {
            Matrix4x4 frame = Matrix4x4.TRS(new Vector3(0.13f, -0.21f, 0.07f), Quaternion.identity, new Vector3(0.4f, 0.52f, 0.6f));
            SpawnResult box = Fill(new LiquidBox("box", frame, Vector3.zero));
            SpawnResult mesh = Fill(new LiquidMesh("mesh", PrimitiveTessellator.Box(frame), Vector3.zero));
            Assert.That(mesh.Particles.Count, Is.EqualTo(box.Particles.Count));
            for (int i = 0; i < box.Particles.Count; i++)
            {
                Assert.That((mesh.Particles[i].Position - box.Particles[i].Position).magnitude, Is.LessThan(1e-5f));
            }
        }

        [Test]
        public void ABoxAnchorsTheLatticeBeforeASphere()
        {
            var drop = new LiquidEllipsoid("drop", Matrix4x4.TRS(new Vector3(0.013f, 0.5f, 0f), Quaternion.identity, 0.33f * Vector3.one),
                Vector3.zero);
            var pool = new LiquidBox("pool", Matrix4x4.TRS(new Vector3(0f, -0.8f, 0f), Quaternion.identity, new Vector3(2f, 0.4f, 2f)),
                Vector3.zero);
            float lowest = Fill(drop, pool).Particles.Min(p => p.Position.y);
            Assert.That(lowest, Is.EqualTo(-1f + 0.5f * Spacing).Within(1e-5f));
        }

        [Test]
        public void OfASphereHalfOutsideHalfIsReported()
        {
            SpawnResult result =
                Fill(new LiquidEllipsoid("drop", Matrix4x4.TRS(new Vector3(1f, 0f, 0f), Quaternion.identity, 0.8f * Vector3.one),
                    Vector3.zero));
            Assert.That(result.Tallies[0].OutsideShare, Is.EqualTo(0.5).Within(0.01));
        }

        [Test]
        public void OpenEdgesAreCounted()
        {
            Assert.That(TestMeshes.Sheet().OpenEdges().Count, Is.EqualTo(4));
            Assert.That(TestMeshes.Sphere(1f, 0.1f).OpenEdges(), Is.Empty);
        }

        private static SpawnResult Fill(params LiquidShape[] shapes) =>
            FluidSpawner.Fill(new SpawnRequest { DomainSize = new Vector3(2f, 2f, 2f), Spacing = Spacing, Shapes = shapes });
    }
}
