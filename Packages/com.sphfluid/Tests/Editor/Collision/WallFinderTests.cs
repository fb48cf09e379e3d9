using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The wall nearest to a place: faces of the domain and colliders.</summary>
    public sealed class WallFinderTests
    {
        private static readonly Vector3 Anywhere = new Vector3(0.3f, 0.5f, -0.8f).normalized;

        private static FluidSolverSettings Settings => BodyRig.Water(Vector3.one, 0.05f, 0.5f); // R = 0.1125

        private static WallPlace? Find(Vector3 place, Vector3 forward, params TriangleMesh[] meshes) =>
            Find(Settings, place, forward, meshes);

        private static WallPlace? Find(in FluidSolverSettings settings, Vector3 place, Vector3 forward, params TriangleMesh[] meshes)
        {
            using (var obstacles = new FluidObstacles(settings))
            {
                foreach (TriangleMesh mesh in meshes) obstacles.Add(mesh, Matrix4x4.identity);
                obstacles.Update(Matrix4x4.identity);
                return WallFinder.Find(new List<FluidObstacle>(obstacles.Found), settings, place, forward);
            }
        }

        private static TriangleMesh Cube => TriangleMesh.Box(Matrix4x4.Scale(0.2f * Vector3.one));

        [TestCase(0, -1f)]
        [TestCase(0, 1f)]
        [TestCase(1, -1f)]
        [TestCase(1, 1f)]
        [TestCase(2, -1f)]
        [TestCase(2, 1f)]
        public void AFaceOfTheDomainIsFoundWithItsNormalInwards(int axis, float side)
        {
            Vector3 place = new Vector3(0.11f, 0.07f, -0.05f), point = place, normal = Vector3.zero;
            place[axis] = side * 0.44f;
            point[axis] = side * 0.5f;
            normal[axis] = -side;
            WallPlace found = Find(place, Anywhere).Value;
            Assert.That((found.Point, found.Normal, found.Obstacle), Is.EqualTo((point, normal, (FluidObstacle)null)));
            Assert.That(found.Distance, Is.EqualTo(0.06f).Within(1e-6f));
            place[axis] = side * 0.53f; // put a little too far
            Assert.That(Find(place, Anywhere).Value.Normal, Is.EqualTo(normal));
            place[axis] = side * 0.38f;
            Assert.That(Find(place, Anywhere), Is.Null, "out of reach");
        }

        [Test]
        public void OpenAndPeriodicFacesAreNoWalls()
        {
            FluidSolverSettings settings = Settings;
            settings.Boundaries.Open = FluidFaces.HighX;
            settings.Boundaries.Periodic = FluidAxes.Z;
            Assert.That(Find(settings, new Vector3(0.49f, 0f, 0f), Anywhere), Is.Null);
            Assert.That(Find(settings, new Vector3(0f, 0f, 0.49f), Anywhere), Is.Null);
            Assert.That(Find(settings, new Vector3(-0.49f, 0f, 0f), Anywhere).HasValue);
        }

        [TestCase(0.15f)]
        [TestCase(0.07f, Description = "from within the cube")]
        public void TheNormalOfAClosedColliderPointsOutOfIt(float height)
        {
            WallPlace found = Find(new Vector3(0.02f, height, -0.03f), Anywhere, Cube).Value;
            Assert.That((found.Point - new Vector3(0.02f, 0.1f, -0.03f)).magnitude, Is.LessThan(1e-6f));
            Assert.That((found.Normal - Vector3.up).magnitude, Is.LessThan(1e-6f));
            Assert.That(found.Obstacle, Is.Not.Null);
        }

        [TestCase(0.03f, 1f)]
        [TestCase(-0.03f, 1f)]
        [TestCase(0f, 1f)]
        [TestCase(0f, -1f)]
        public void OfASheetTheSideCountsThatTheProbeIsOnOrLooksFrom(float height, float forward)
        {
            TriangleMesh sheet =
                TriangleMesh.FromCorners(new[] { new Vector3(-0.2f, 0f, -0.2f), new Vector3(0.2f, 0f, -0.2f), new Vector3(0f, 0f, 0.3f) });
            float side = height == 0f ? forward : Mathf.Sign(height);
            Assert.That((Find(new Vector3(0f, height, 0f), forward * Vector3.up, sheet).Value.Normal - side * Vector3.up).magnitude,
                Is.LessThan(1e-6f));
        }

        [Test]
        public void OnAnEdgeTheWallCountsThatFacesForward()
        {
            Assert.That((Find(new Vector3(0.1f, 0.1f, 0f), Vector3.right, Cube).Value.Normal - Vector3.right).magnitude,
                Is.LessThan(1e-6f));
            Assert.That((Find(new Vector3(0.1f, 0.1f, 0f), Vector3.up, Cube).Value.Normal - Vector3.up).magnitude, Is.LessThan(1e-6f));
            Assert.That(Find(new Vector3(-0.48f, -0.48f, 0f), Vector3.up).Value.Normal, Is.EqualTo(Vector3.up));
            Assert.That(Find(new Vector3(-0.48f, -0.48f, 0f), Vector3.right).Value.Normal, Is.EqualTo(Vector3.right));
        }
    }
}
