using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// Liquid boxes are filled with as many particles as their volume holds, once, inside the domain, the same every time.
    /// </summary>
    public sealed class FluidSpawnerTests
    {
        [TestCase(0.4f, 0.2f, 0.6f, 0.1f, 4 * 2 * 6)]
        [TestCase(1f, 1f, 1f, 0.05f, 8000)]
        [TestCase(0.3f, 0.3f, 0.3f, 0.3f, 1)]
        [TestCase(0.5f, 0.25f, 1f, 0.0625f, 8 * 4 * 16)]
        public void BoxOfWholeSpacingsHoldsItsVolume(float x, float y, float z, float spacing, int expected)
        {
            SpawnResult result = FluidSpawner.Fill(Request(spacing, Box(Vector3.zero, new Vector3(x, y, z))));
            Assert.That(result.Particles.Count, Is.EqualTo(expected));
            Assert.That(result.Particles.Count * Math.Pow(spacing, 3), Is.EqualTo(x * (double)y * z).Within(1e-4 * x * y * z));
        }

        [Test]
        public void OuterLayersLieHalfASpacingInsideTheFaces()
        {
            SpawnResult result = FluidSpawner.Fill(Request(0.1f, Box(new Vector3(0.13f, -0.21f, 0.07f), new Vector3(0.4f, 0.5f, 0.6f))));
            Assert.That(result.Particles.Min(p => p.Position.x), Is.EqualTo(0.13f - 0.2f + 0.05f).Within(1e-5f));
            Assert.That(result.Particles.Max(p => p.Position.x), Is.EqualTo(0.13f + 0.2f - 0.05f).Within(1e-5f));
            Assert.That(result.Particles.Min(p => p.Position.y), Is.EqualTo(-0.21f - 0.25f + 0.05f).Within(1e-5f));
            Assert.That(result.Particles.Max(p => p.Position.z), Is.EqualTo(0.07f + 0.3f - 0.05f).Within(1e-5f));
        }

        [TestCase(1.04f, 10)]
        [TestCase(0.96f, 10)]
        [TestCase(1.06f, 11)]
        public void BoxThatIsNoWholeNumberOfSpacingsIsFilledToTheNearestLayer(float width, int layers)
        {
            SpawnResult result = FluidSpawner.Fill(Request(0.1f, Box(Vector3.zero, new Vector3(width, 0.1f, 0.1f))));
            Assert.That(result.Particles.Count, Is.EqualTo(layers));
            Assert.That(result.Particles.Sum(p => p.Position.x), Is.EqualTo(0f).Within(1e-4f), "what is left over is shared by both faces");
        }

        // The domain goes from -1 to 1 m.
        [TestCase(-1f, 0.04f, 0.1f, FluidFaces.All, -0.95f, -0.05f)]
        [TestCase(-1f, 0.06f, 0.1f, FluidFaces.All, -0.95f, 0.05f)]
        [TestCase(-0.06f, 1f, 0.1f, FluidFaces.All, -0.05f, 0.95f)]
        [TestCase(-1.3f, 0.06f, 0.1f, FluidFaces.All, -0.95f, 0.05f)]
        [TestCase(-1f, 1f, 0.19f, FluidFaces.All, -0.855f, 0.855f)]
        [TestCase(-1f, 1f, 0.19f, FluidFaces.LowX, -0.905f, 0.805f)]
        [TestCase(-1f, 1f, 0.19f, FluidFaces.None, -0.95f, 0.95f)]
        [TestCase(-1f, 1f, 0.1f, FluidFaces.All, -0.95f, 0.95f)]
        public void NoLayerIsNearerThanHalfASpacingToAWall(float low, float high, float spacing, FluidFaces walls, float first, float last)
        {
            SpawnRequest request = Request(spacing, Box(0.5f * (low + high) * Vector3.right, new Vector3(high - low, spacing, spacing)));
            request.Walls = walls;

            List<FluidParticle> particles = FluidSpawner.Fill(request).Particles;

            Assert.That(particles.Min(p => p.Position.x), Is.EqualTo(first).Within(1e-5f));
            Assert.That(particles.Max(p => p.Position.x), Is.EqualTo(last).Within(1e-5f));
        }

        [Test]
        public void TurnedBoxHoldsItsVolume()
        {
            Matrix4x4 turned = Matrix4x4.TRS(new Vector3(0.1f, 0f, -0.05f), Quaternion.Euler(25f, 40f, 10f), new Vector3(0.8f, 0.6f, 0.5f));
            SpawnResult result = FluidSpawner.Fill(Request(0.02f, new LiquidBox("turned", turned, Vector3.zero)));
            Assert.That(result.Particles.Count, Is.EqualTo(0.8 * 0.6 * 0.5 / Math.Pow(0.02, 3)).Within(1).Percent);
        }

        [Test]
        public void OverlapIsFilledOnce()
        {
            SpawnResult result = FluidSpawner.Fill(Request(0.1f,
                Box(new Vector3(-0.2f, 0f, 0f), new Vector3(0.8f, 0.4f, 0.4f), new Vector3(1f, 0f, 0f)),
                Box(new Vector3(0.2f, 0f, 0f), new Vector3(0.8f, 0.4f, 0.4f), new Vector3(2f, 0f, 0f))));
            Assert.That(result.Particles.Count, Is.EqualTo(12 * 4 * 4));
            Assert.That(result.Tallies[1].Shared, Is.EqualTo(4 * 4 * 4));
            Assert.That(result.Particles.Count(p => p.VelT0.x == 1f), Is.EqualTo(8 * 4 * 4), "the first box gives the velocity");
            Assert.That(SmallestDistance(result.Particles), Is.EqualTo(0.1f).Within(1e-4f));
        }

        [Test]
        public void TouchingBoxesFitTogether()
        {
            SpawnResult result = FluidSpawner.Fill(Request(0.1f,
                Box(new Vector3(-0.2f, 0f, 0f), new Vector3(0.4f, 0.4f, 0.4f)),
                Box(new Vector3(0.2f, 0f, 0f), new Vector3(0.4f, 0.4f, 0.4f))));
            Assert.That(result.Particles.Count, Is.EqualTo(8 * 4 * 4));
            Assert.That(result.Tallies[1].Shared, Is.Zero);
        }

        [Test]
        public void LiquidOutsideTheDomainIsLeftOutAndMeasured()
        {
            SpawnRequest request = Request(0.1f, Box(new Vector3(1f, 0f, 0f), new Vector3(1f, 0.4f, 0.4f)));
            SpawnResult result = FluidSpawner.Fill(request);
            Assert.That(result.Particles.Count, Is.EqualTo(5 * 4 * 4));
            Assert.That(result.Tallies[0].OutsideShare, Is.EqualTo(0.5).Within(0.02));

            request.Shapes = new[] { Box(new Vector3(3f, 0f, 0f), new Vector3(1f, 0.4f, 0.4f)) };
            result = FluidSpawner.Fill(request);
            Assert.That(result.Particles, Is.Empty);
            Assert.That(result.Tallies[0].OutsideShare, Is.EqualTo(1.0));
        }

        [Test]
        public void ObstaclesAreCarvedAndCounted()
        {
            SpawnRequest request = Request(0.1f, Box(Vector3.zero, new Vector3(0.8f, 0.4f, 0.4f)));
            request.Obstacle = point => point.x > 0f ? 7 : -1;
            SpawnResult result = FluidSpawner.Fill(request);
            Assert.That(result.Particles.Count, Is.EqualTo(4 * 4 * 4));
            Assert.That(result.Tallies[0].Carved, Is.EqualTo(4 * 4 * 4));
            Assert.That(result.Tallies[0].LastObstacle, Is.EqualTo(7));
        }

        [Test]
        public void JitterIsBoundedSeededAndStaysInTheDomain()
        {
            SpawnRequest request = Request(0.1f, Box(Vector3.zero, new Vector3(2f, 2f, 2f)));
            List<FluidParticle> plain = FluidSpawner.Fill(request).Particles;
            request.Jitter = FluidSpawner.MaxJitter;
            request.Seed = 5;
            List<FluidParticle> first = FluidSpawner.Fill(request).Particles, again = FluidSpawner.Fill(request).Particles;
            request.Seed = 6;
            List<FluidParticle> other = FluidSpawner.Fill(request).Particles;

            float largest = 0f, mean = 0f;
            for (int i = 0; i < plain.Count; i++)
            {
                Vector3 offset = first[i].Position - plain[i].Position;
                largest = Mathf.Max(largest, Mathf.Max(Mathf.Abs(offset.x), Mathf.Max(Mathf.Abs(offset.y), Mathf.Abs(offset.z))));
                mean += offset.x / plain.Count;
                Assert.That(first[i].Position, Is.EqualTo(again[i].Position));
                Assert.That(Mathf.Abs(first[i].Position.y), Is.LessThan(1f));
            }
            Assert.That(largest, Is.InRange(0.018f, 0.0201f));
            Assert.That(mean, Is.EqualTo(0f).Within(0.001f), "8,000 offsets of ±20 mm have a mean below 1 mm");
            Assert.That(first.Zip(other, (a, b) => a.Position == b.Position).Count(same => same), Is.LessThan(8));
        }

        [Test]
        public void IdsRunFromZeroWithoutGaps()
        {
            SpawnResult result = FluidSpawner.Fill(Request(0.1f, Box(Vector3.zero, new Vector3(0.5f, 0.5f, 0.5f))));
            Assert.That(result.Particles.Select(p => p.Id), Is.EqualTo(Enumerable.Range(0, 125).Select(i => (uint)i)));
        }

        [Test]
        public void MoreThanTheCapMakesNoneAndTellsHowManyAreNeeded()
        {
            SpawnRequest request = Request(0.1f, Box(Vector3.zero, new Vector3(1f, 1f, 1f)));
            request.MaxParticles = 999;
            SpawnResult result = FluidSpawner.Fill(request);
            Assert.That(result.TooMany);
            Assert.That(result.Particles, Is.Empty);
            Assert.That(result.Needed, Is.EqualTo(1000));

            request.Spacing = 1e-6f;
            result = FluidSpawner.Fill(request);
            Assert.That(result.Needed, Is.EqualTo(1e18).Within(1).Percent, "an impossible number is estimated, not walked through");
        }

        [TestCase(1000)]
        [TestCase(16000)]
        [TestCase(777)]
        public void SpacingForACountKeepsTheVolume(int count)
        {
            SpawnRequest request = Request(0.1f, Box(new Vector3(-0.3f, -0.25f, 0f), new Vector3(0.61f, 1.23f, 0.87f)));
            request.Spacing = ParticleCountFit.Spacing(request, count);
            long found = FluidSpawner.Measure(request).Needed;
            Assert.That(found, Is.EqualTo(count).Within(8).Percent);
            Assert.That(found * Math.Pow(request.Spacing, 3), Is.EqualTo(0.61 * 1.23 * 0.87).Within(12).Percent);
        }

        // At 0.0416 m 420 particles are nearer to 500, but of the tank's 5.8 layers only 5 are there, and a sixth of the liquid is lost.
        [TestCase(500)]
        [TestCase(600)]
        [TestCase(2000)]
        public void SpacingForACountLosesNoLayerBetweenWalls(int count)
        {
            SpawnRequest request = Request(0.1f, Box(new Vector3(-0.3f, -0.05f, 0f), new Vector3(0.3f, 0.5f, 0.24f)));
            request.DomainSize = new Vector3(0.9f, 0.6f, 0.24f);
            request.Spacing = ParticleCountFit.Spacing(request, count);
            long found = FluidSpawner.Measure(request).Needed;
            Assert.That(found, Is.EqualTo(count).Within(25).Percent);
            Assert.That(found * Math.Pow(request.Spacing, 3), Is.EqualTo(0.3 * 0.5 * 0.24).Within(11).Percent);
        }

        [Test]
        public void AVelocityFieldAddsToTheBoxesVelocity()
        {
            SpawnRequest request = Request(0.1f, Box(Vector3.zero, new Vector3(0.5f, 0.3f, 0.7f), new Vector3(1f, 0f, 0f)));
            Assert.That(FluidSpawner.Fill(request).Fastest, Is.EqualTo(1f));
            request.Jitter = 0.1f;
            request.Velocity = p => new Vector3(0f, 0f, 2f * p.x);
            SpawnResult result = FluidSpawner.Fill(request);
            foreach (FluidParticle particle in result.Particles)
            {
                Assert.That(particle.VelT0, Is.EqualTo(new Vector3(1f, 0f, 2f * particle.Position.x)));
                Assert.That(particle.VelT1, Is.EqualTo(particle.VelT0));
            }
            Assert.That(result.Fastest, Is.EqualTo(result.Particles.Max(p => p.VelT0.magnitude)));
            request.Jitter = 0f;
            Assert.That(FluidSpawner.Measure(request).Fastest, Is.EqualTo(FluidSpawner.Fill(request).Fastest));
            request.Velocity = p => new Vector3(p.x > 0.1f ? float.NaN : 0f, 0f, 0f);
            Assert.That(FluidSpawner.Measure(request).Fastest, Is.NaN);
        }

        [Test]
        public void BadRequestsAreNamed()
        {
            SpawnRequest request = Request(0f, Box(Vector3.zero, Vector3.one));
            Assert.That(() => FluidSpawner.Fill(request), Throws.ArgumentException.With.Message.Contains("spacing"));
            request = Request(0.1f, Box(Vector3.zero, Vector3.one));
            request.DomainSize = new Vector3(1f, float.NaN, 1f);
            Assert.That(() => FluidSpawner.Fill(request), Throws.ArgumentException.With.Message.Contains("domain"));
            Assert.That(() => ParticleCountFit.Spacing(Request(0.1f), 10), Throws.InvalidOperationException);
            Assert.That(() => ParticleCountFit.Spacing(Request(0.1f), 0), Throws.InstanceOf<ArgumentOutOfRangeException>());
        }

        private static SpawnRequest Request(float spacing, params LiquidBox[] boxes) =>
            new SpawnRequest { DomainSize = new Vector3(2f, 2f, 2f), Spacing = spacing, Shapes = boxes };

        private static LiquidBox Box(Vector3 center, Vector3 size, Vector3 velocity = default) =>
            new LiquidBox("box", Matrix4x4.TRS(center, Quaternion.identity, size), velocity);

        private static float SmallestDistance(List<FluidParticle> particles)
        {
            float smallest = float.MaxValue;
            for (int i = 0; i < particles.Count; i++)
                for (int j = 0; j < i; j++) smallest = Mathf.Min(smallest, (particles[i].Position - particles[j].Position).magnitude);
            return smallest;
        }
    }
}
