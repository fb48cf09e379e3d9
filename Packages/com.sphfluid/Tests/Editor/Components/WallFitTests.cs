using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A box of liquid that ends near walls of its domain rests against them, level and with its volume.</summary>
    public sealed class WallFitTests
    {
        private const float Spacing = 0.1f;
        private static readonly Vector3 Domain = new Vector3(1.2f, 1f, 1.24f);
        private static readonly Vector3 Gravity = new Vector3(0f, -9.81f, 0f);

        [TestCase(0f)]
        [TestCase(0.3f)]
        [TestCase(0.9f)]
        public void ItIsDrawnOutToThem(float gap)
        {
            Bounds pool = Drawn(Pool(gap, 0.4f), FluidFaces.All);
            Assert.That((pool.min + 0.5f * Domain).magnitude, Is.LessThan(1e-5f));
            Assert.That((pool.max - new Vector3(0.6f, -0.1f, 0.62f)).magnitude, Is.LessThan(1e-5f), "its level stays");
            FluidFaces at = WallFit.At(pool, Domain, FluidFaces.All, Spacing);
            Assert.That(at, Is.EqualTo(FluidFaces.All & ~FluidFaces.HighY));
        }

        [Test]
        public void OtherwiseItStaysAsItIs()
        {
            Bounds far = Pool(1.1f, 0.4f), full = Pool(0.5f, 0.95f);
            Assert.That(Drawn(far, FluidFaces.All), Is.EqualTo(far), "more than a spacing");
            Assert.That(Drawn(Pool(0.5f, 0.4f), FluidFaces.None), Is.EqualTo(Pool(0.5f, 0.4f)), "no walls");
            Assert.That(Drawn(full, FluidFaces.All).max.y, Is.EqualTo(full.max.y), "liquid does not hang on a ceiling");
        }

        [TestCase(0.39f, 4)]
        [TestCase(0.45f, 5)]
        public void ItsLayersAreLevelFromWallToWall(float depth, int layers)
        {
            Bounds pool = Drawn(Pool(0.3f, depth), FluidFaces.All);
            var box = new LiquidBox("pool", Matrix4x4.TRS(pool.center, Quaternion.identity, pool.size), Vector3.zero,
                WallFit.At(pool, Domain, FluidFaces.All, Spacing));
            var request = new SpawnRequest { DomainSize = Domain, Spacing = Spacing, Shapes = new[] { box } };
            List<FluidParticle> particles = FluidSpawner.Fill(request).Particles;
            Assert.That(particles.Count * Mathf.Pow(Spacing, 3f), Is.EqualTo(box.Volume).Within(4).Percent);
            float step = Domain.z / 12f;
            Assert.That(particles.Min(p => p.Position.z), Is.EqualTo(0.5f * (step - Domain.z)).Within(1e-5f));
            Assert.That(particles.Max(p => p.Position.z), Is.EqualTo(0.5f * (Domain.z - step)).Within(1e-5f));
            Assert.That(particles.Select(p => Mathf.RoundToInt(1e4f * p.Position.y)).Distinct().Count(), Is.EqualTo(layers));
        }

        private static Bounds Drawn(Bounds box, FluidFaces walls) => WallFit.DrawnOut(box, Domain, walls, Spacing, Gravity);

        // From the floor's side up to a height, a gap of so many spacings from the floor and the sides.
        private static Bounds Pool(float gap, float height)
        {
            Vector3 inset = gap * Spacing * Vector3.one, low = -0.5f * Domain + inset, high = 0.5f * Domain - inset;
            high.y = height - 0.5f * Domain.y;
            var pool = new Bounds();
            pool.SetMinMax(low, high);
            return pool;
        }
    }
}
