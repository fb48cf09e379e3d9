using System;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Dual marching cubes on fields that are written by hand.</summary>
    public sealed class DualMarchingCubesTests
    {
        private const float Iso = 0.5f;

        [Test]
        public void ASphereIsClosedAndOfTheRightSize()
        {
            SurfaceMesh mesh = Polygonise(32, p => Iso + 0.3f - (p - 0.01f * Vector3.one).magnitude, true);

            MeshEdges edges = MeshEdges.Of(mesh);
            Assert.That(edges.IsClosed, Is.True);
            Assert.That(edges.Euler, Is.EqualTo(2));
            Assert.That(mesh.Volume() / (4.0 / 3.0 * Math.PI * Math.Pow(0.3, 3)), Is.EqualTo(1.0).Within(0.02));
            Assert.That(NormalError.Of(mesh, p => (p - 0.01f * Vector3.one).normalized).Shading, Is.LessThan(1.0));
            Assert.That(TriangleShapes.Of(mesh, 1f / 32f).LeastAngle, Is.GreaterThan(20.0));
        }

        [Test]
        public void LiquidInTheWholeDomainIsTheDomain()
        {
            SurfaceMesh mesh = Polygonise(8, _ => 1f, true);

            Assert.That(MeshEdges.Of(mesh).IsClosed, Is.True);
            Assert.That(mesh.Volume(), Is.EqualTo(1.0).Within(0.01));
        }

        [Test]
        public void OnlyTheFlipMakesNoiseAManifold()
        {
            MeshEdges plain = MeshEdges.Of(Noise(false)), flipped = MeshEdges.Of(Noise(true));

            Assert.That((plain.OpenEdges, plain.FlippedEdges), Is.EqualTo((0, 0)));
            Assert.That(plain.NonManifoldEdges, Is.GreaterThan(0));
            Assert.That(flipped.IsClosed, Is.True);
        }

        private static SurfaceMesh Noise(bool flip)
        {
            var random = new System.Random(5);
            return Polygonise(20, _ => (float)random.NextDouble(), flip);
        }

        private static SurfaceMesh Polygonise(int cells, Func<Vector3, float> field, bool flip)
        {
            var grid = new SurfaceGrid(-0.5f * Vector3.one, Vector3.one, cells);
            var values = new float[grid.VertexCount];
            for (int z = 0; z <= cells; z++)
                for (int y = 0; y <= cells; y++)
                    for (int x = 0; x <= cells; x++) values[grid.Index(x, y, z)] = field(grid.Position(x, y, z));
            return DualMarchingCubes.Polygonise(grid, values, Iso, flip);
        }
    }
}
