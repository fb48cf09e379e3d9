using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Faces of the domain as layers of particles.</summary>
    public sealed class DomainWallsTests
    {
        private const float Spacing = 0.1f;

        private static readonly Vector3 Size = new Vector3(0.3f, 0.5f, 0.7f);

        private static bool IsIn(Vector3 p, Vector3 size) => Mathf.Abs(p.x) < 0.5f * size.x && Mathf.Abs(p.y) < 0.5f * size.y &&
            Mathf.Abs(p.z) < 0.5f * size.z;

        [Test]
        public void AClosedBoxIsWrappedInLayers([Values(1, 2, 3)] int layers)
        {
            List<WallParticle> walls = DomainWalls.Of(Size, Spacing, layers, default);

            int Sites(int more) => (3 + more) * (5 + more) * (7 + more);
            Assert.That(walls.Count, Is.EqualTo(Sites(2 * layers) - Sites(0)));
            Assert.That(walls.Any(w => IsIn(w.Position, Size)), Is.False);
            Assert.That(walls.Select(w => w.Position).Distinct().Count(), Is.EqualTo(walls.Count));
        }

        [Test]
        public void TheFirstLayerLiesHalfASpacingBehindTheFace()
        {
            List<WallParticle> walls = DomainWalls.Of(Size, Spacing, 2, default);

            float[] floor = walls.Where(w => Mathf.Abs(w.Position.x) < 0.15f && Mathf.Abs(w.Position.z) < 0.35f && w.Position.y < 0f)
                .Select(w => w.Position.y).Distinct().OrderBy(y => -y).ToArray();
            Assert.That(floor, Is.EqualTo(new[] { -0.3f, -0.4f }).Within(1e-6f));
        }

        [Test]
        public void ADomainThatIsNoWholeNumberOfSpacingsIsStretched()
        {
            var size = new Vector3(0.33f, 0.27f, 0.1f);
            float[] along = DomainWalls.Of(size, Spacing, 1, default)
                .Where(w => Mathf.Abs(w.Position.x) < 0.165f && w.Position.y < -0.135f && Mathf.Abs(w.Position.z) < 0.05f)
                .Select(w => w.Position.x).OrderBy(x => x).ToArray();

            Assert.That(along, Is.EqualTo(new[] { -0.11f, 0f, 0.11f }).Within(1e-6f));
        }

        [Test]
        public void OpenAndPeriodicFacesHaveNone()
        {
            List<WallParticle> walls =
                DomainWalls.Of(Size, Spacing, 2, new FluidBoundaries { Open = FluidFaces.HighY, Periodic = FluidAxes.Z });

            Assert.That(walls.Max(w => w.Position.y), Is.LessThan(0.25f));
            Assert.That(walls.Min(w => w.Position.y), Is.EqualTo(-0.4f).Within(1e-6f));
            Assert.That(walls.Max(w => Mathf.Abs(w.Position.z)), Is.LessThan(0.35f));
            Assert.That(walls.Count, Is.EqualTo((2 * 5 * 2 + 7 * 2) * 7),
                "two sides of five rows and a floor of seven columns, two layers, seven slices");
        }

        [Test]
        public void WithoutWallsThereIsNothing() =>
            Assert.That(DomainWalls.Of(Size, Spacing, 3, new FluidBoundaries { Periodic = FluidAxes.All }), Is.Empty);

        [Test]
        public void ABeltHasItsVelocity()
        {
            List<WallParticle> walls =
                DomainWalls.Of(Size, Spacing, 2, new FluidBoundaries { Friction = 1f, LowY = new Vector3(2f, 0f, 0f) });

            foreach (WallParticle wall in walls.Where(w => Mathf.Abs(w.Position.x) < 0.15f && Mathf.Abs(w.Position.z) < 0.35f))
            {
                Assert.That(wall.Velocity, Is.EqualTo(wall.Position.y < 0f ? new Vector3(2f, 0f, 0f) : Vector3.zero));
            }
        }
    }
}
