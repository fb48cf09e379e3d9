using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What of a rectangle lies on a wall, and where the wall ends.</summary>
    public sealed class WallCoverTests
    {
        private const float Spacing = 0.05f;

        private static FluidSolverSettings Settings => BodyRig.Water(new Vector3(1f, 1.2f, 1.4f), Spacing, 0.5f);

        // Of a rectangle that faces along z unless it is turned, so that its x and y are the world's.
        private static WallCover Cover(in FluidSolverSettings settings, Vector3 centre, Quaternion rotation, Vector2 size,
            params TriangleMesh[] meshes)
        {
            using (var obstacles = new FluidObstacles(settings))
            {
                foreach (TriangleMesh mesh in meshes) obstacles.Add(mesh, Matrix4x4.identity);
                obstacles.Update(Matrix4x4.identity);
                var patch = new WallPatch { Centre = centre, Rotation = rotation, Size = size };
                return WallCover.Of(patch, Spacing, settings, new List<FluidObstacle>(obstacles.Found));
            }
        }

        private static TriangleMesh Box(Vector3 centre, Vector3 size) =>
            TriangleMesh.Box(Matrix4x4.TRS(centre, Quaternion.identity, size));

        private static void Check(WallCover cover, double area, float left, float right, float down, float up)
        {
            Assert.That(cover.Area, Is.EqualTo(area).Within(0.01).Percent);
            var expected = new Vector4(left, right, down, up);
            for (int side = 0; side < 4; side++)
            {
                if (float.IsInfinity(expected[side])) Assert.That(cover.Ends[side], Is.GreaterThan(1e3f), $"side {side}");
                else Assert.That(cover.Ends[side], Is.EqualTo(expected[side]).Within(1e-4f), $"side {side}");
            }
        }

        private const float Far = float.PositiveInfinity;

        [Test]
        public void ARectangleThatOverhangsTheFaceOfABoxCoversWhatIsThere()
        {
            TriangleMesh box = Box(new Vector3(0.02f, 0f, 0f), new Vector3(0.3f, 0.16f, 0.2f));
            Check(Cover(Settings, new Vector3(0.04f, 0f, 0.1f), Quaternion.identity, new Vector2(0.5f, 0.1f), box), 0.3 * 0.1, 0.17f, 0.13f,
                0.08f, 0.08f);
            Quaternion turned = Quaternion.Euler(0f, 0f, 90f);
            Check(Cover(Settings, new Vector3(0.04f, 0f, 0.1f), turned, new Vector2(0.1f, 0.5f), box), 0.3 * 0.1, 0.08f, 0.08f, 0.13f,
                0.17f);
        }

        [Test]
        public void WhereTheWallGoesOnForMoreThanTwoSpacingsItHasNoEnd()
        {
            TriangleMesh box = Box(Vector3.zero, new Vector3(0.4f, 0.4f, 0.2f));
            Check(Cover(Settings, new Vector3(0.12f, 0f, 0.1f), Quaternion.identity, new Vector2(0.1f, 0.1f), box), 0.01, Far, 0.08f, Far,
                Far);
        }

        // A plate thinner than the rectangle is deep; its back does not count.
        [Test]
        public void ThePlateItselfCountsOnceAndTwoSideBySideAreOneWall([Values(1f, -1f)] float side)
        {
            TriangleMesh left = Box(new Vector3(-0.1f, 0f, 0f), new Vector3(0.2f, 0.2f, 0.01f)), right = Box(new Vector3(0.1f, 0f, 0f),
                new Vector3(0.2f, 0.2f, 0.01f));
            Quaternion rotation = Quaternion.LookRotation(side * Vector3.forward);
            Check(Cover(Settings, new Vector3(0f, 0f, 0.005f * side), rotation, new Vector2(0.6f, 0.1f), left, right), 0.4 * 0.1, 0.2f,
                0.2f, 0.1f, 0.1f);
        }

        // The wall goes on behind the floor, which is a mesh or the domain's.
        [Test]
        public void AnotherWallThatStandsOnItEndsIt([Values] bool isDomain)
        {
            float floor = isDomain ? -0.6f : -0.5f;
            var meshes = new List<TriangleMesh> { Box(new Vector3(0f, 0f, -0.4f), new Vector3(4f, 4f, 0.4f)) };
            if (!isDomain) meshes.Add(Box(new Vector3(0f, -0.6f, 0f), new Vector3(2f, 0.2f, 4f)));
            Check(Cover(Settings, new Vector3(0f, floor + 0.06f, -0.2f), Quaternion.identity, new Vector2(0.2f, 0.2f), meshes.ToArray()),
                0.2 * 0.16, Far, Far, 0.06f, Far);
        }

        [Test]
        public void FacesOfTheDomainEndAtEachOtherAndNotRoundAPeriod()
        {
            FluidSolverSettings settings = Settings;
            settings.Boundaries.Open = FluidFaces.HighY;
            settings.Boundaries.Periodic = FluidAxes.Z;
            var floor = new Vector3(0.4f, -0.6f, 0.65f);
            Quaternion up = Quaternion.LookRotation(Vector3.up, Vector3.forward); // x to the left
            Check(Cover(settings, floor, up, new Vector2(0.3f, 0.3f)), 0.25 * 0.3, 0.1f, Far, Far, Far);
            Check(Cover(settings, new Vector3(0.4f, 0.6f, 0f), Quaternion.LookRotation(Vector3.down, Vector3.forward),
                new Vector2(0.3f, 0.3f)), 0.09, Far, Far, Far, Far); // an open face is none
        }

        [Test]
        public void ADiscCountsByItsAreaAndARoundWallIsNotItsOwnEnd()
        {
            TriangleMesh round = TestMeshesOf(0.1f, 0.4f, 48);
            double area = 24.0 * 0.01 * Mathf.Sin(2f * Mathf.PI / 48f);
            WallCover disc = Cover(Settings, new Vector3(0f, 0f, 0.2f), Quaternion.identity, new Vector2(0.4f, 0.4f), round);
            Assert.That(disc.Area, Is.EqualTo(area).Within(0.01).Percent);
            Assert.That(disc.Ends.x, Is.InRange(0.07f, 0.1f));
            WallCover side = Cover(Settings, new Vector3(0.1f, 0f, 0f), Quaternion.LookRotation(Vector3.right, Vector3.forward),
                new Vector2(0.05f, 0.1f), round);
            Assert.That(side.Area, Is.EqualTo(0.005).Within(0.01).Percent);
        }

        [Test]
        public void WhereThereIsNoWallItIsTheWholeRectangle() =>
            Check(Cover(Settings, Vector3.zero, Quaternion.Euler(10f, 20f, 30f), new Vector2(0.2f, 0.3f)), 0.06, Far, Far, Far, Far);

        // A closed cylinder about z.
        private static TriangleMesh TestMeshesOf(float radius, float length, int sides)
        {
            var corners = new List<Vector3>();
            for (int i = 0; i < sides; i++)
            {
                float a = 2f * Mathf.PI * i / sides, b = 2f * Mathf.PI * (i + 1) / sides;
                Vector3 p = radius * new Vector3(Mathf.Cos(a), Mathf.Sin(a), 0f), q = radius * new Vector3(Mathf.Cos(b), Mathf.Sin(b), 0f);
                Vector3 up = 0.5f * length * Vector3.forward;
                corners.AddRange(new[] { up, p + up, q + up, -up, q - up, p - up, p - up, q - up, q + up, p - up, q + up, p + up });
            }
            return TriangleMesh.FromCorners(corners);
        }
    }
}
