using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Where the points of a level are, and the level that densities on them make.</summary>
    public sealed class SensorLineTests
    {
        private const float Spacing = 0.05f;
        private static readonly Vector3 Domain = new Vector3(2f, 1f, 2f);

        [Test]
        public void PointsAreHalfASpacingApartOrLess()
        {
            SensorLine line = SensorLine.Create(new Vector3(0f, -0.5f, 0f), Vector3.up, 0.8f, Domain, Spacing);
            Assert.That(line.First, Is.Zero);
            Assert.That(line.Step, Is.InRange(0.4f * Spacing, 0.5f * Spacing));
            Assert.That(line.First + (line.Count - 1) * line.Step, Is.EqualTo(0.8f).Within(1e-5f));
        }

        [Test]
        public void OnlyThePartInTheDomainHasPoints()
        {
            SensorLine line = SensorLine.Create(new Vector3(0.3f, -0.8f, 0f), Vector3.up, 50f, Domain, Spacing);
            Assert.That(line.First, Is.EqualTo(0.3f).Within(1e-5f));
            Assert.That(line.First + (line.Count - 1) * line.Step, Is.EqualTo(1.3f).Within(1e-4f));
            SensorLine slanted = SensorLine.Create(new Vector3(-1.3f, 0f, 0f), Vector3.right, 1f, Domain, Spacing);
            Assert.That(slanted.First, Is.EqualTo(0.3f).Within(1e-5f));
        }

        [TestCase(3f, 0f, 0f)]
        [TestCase(0f, 0.6f, 0f)]
        [TestCase(0f, -9f, 0f)]
        public void BesideTheDomainTheLevelIsZero(float x, float y, float z)
        {
            SensorLine line = SensorLine.Create(new Vector3(x, y, z), Vector3.up, 1f, Domain, Spacing);
            Assert.That(line.Step, Is.Zero);
            Assert.That(line.Level(new float[line.Count], 1000f), Is.Zero);
        }

        [TestCase(0f)]
        [TestCase(-1f)]
        [TestCase(float.NaN)]
        public void ALineOfNoLengthHasTwoPoints(float length)
        {
            SensorLine line = SensorLine.Create(Vector3.zero, Vector3.up, length, Domain, Spacing);
            Assert.That(line.Count, Is.EqualTo(2));
            Assert.That(line.Level(new[] { 0f, 0f }, 1000f), Is.Zero);
        }

        [Test]
        public void AnEndlessLineHasPointsForTheDomainOnly()
        {
            SensorLine line = SensorLine.Create(Vector3.zero, Vector3.up, float.PositiveInfinity, Domain, Spacing);
            Assert.That(line.Count, Is.LessThan(200));
            Assert.That(line.First + (line.Count - 1) * line.Step, Is.EqualTo(0.5f).Within(1e-5f));
        }

        [Test]
        public void TheLevelIsWhereTheDensityFallsBelowHalf()
        {
            SensorLine line = SensorLine.Create(new Vector3(0f, -0.5f, 0f), Vector3.up, 1f, Domain, Spacing);
            for (float level = 0.1f; level < 0.9f; level += 0.037f)
            {
                float[] densities = Enumerable.Range(0, line.Count)
                    .Select(i => 1000f * Mathf.Clamp01(0.5f - (line.First + i * line.Step - level) / (2f * Spacing))).ToArray();
                Assert.That(line.Level(densities, 1000f), Is.EqualTo(level).Within(1e-4f));
            }
        }

        [Test]
        public void TheLowestLiquidCounts()
        {
            SensorLine line = SensorLine.Create(new Vector3(0f, -0.5f, 0f), Vector3.up, 1f, Domain, Spacing);
            var densities = new float[line.Count];
            for (int i = 3; i < 9; i++) densities[i] = 1000f; // the floor's points are beside a wall that takes density away
            for (int i = 20; i < 25; i++) densities[i] = 1000f;
            Assert.That(line.Level(densities, 1000f), Is.EqualTo(8.5f * line.Step).Within(1e-5f));
        }

        [Test]
        public void AFullLineHasItsUpperEnd()
        {
            SensorLine line = SensorLine.Create(new Vector3(0f, -0.5f, 0f), Vector3.up, 0.5f, Domain, Spacing);
            Assert.That(line.Level(Enumerable.Repeat(1000f, line.Count).ToArray(), 1000f), Is.EqualTo(0.5f).Within(1e-5f));
        }
    }
}
