using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>How far the liquid can fall and how fast a force can make it.</summary>
    public sealed class LiquidExtentTests
    {
        private static readonly Vector3 Domain = new Vector3(2f, 3f, 4f);
        private static readonly Vector3 Down = new Vector3(0f, -9.81f, 0f);

        [Test]
        public void FallHeightIsFromTheTopOfTheLiquidToTheFloor()
        {
            LiquidExtent extent = Extent(new Vector3(0f, 0.5f, 0f), new Vector3(1f, 1f, 1f));
            Assert.That(extent.FallHeight(Down), Is.EqualTo(1.5f + 1f).Within(1e-5f));
            Assert.That(extent.FallHeight(new Vector3(5f, 0f, 0f)), Is.EqualTo(1f + 0.5f).Within(1e-5f), "sideways gravity");
            Assert.That(extent.FallHeight(Vector3.zero), Is.Zero);
        }

        [Test]
        public void LiquidAboveTheDomainFallsNoFartherThanTheDomain() =>
            Assert.That(Extent(new Vector3(0f, 1.5f, 0f), Vector3.one).FallHeight(Down), Is.EqualTo(3f).Within(1e-5f));

        [Test]
        public void ABodyForceGivesItsRateTimesTheDistance()
        {
            // A metre's cube at 0.5 m: along y up to 1 m from the centre, along x 0.5 m. ω² = 9 and 16: v² = 9 · 0.25 + 16 · 1.
            LiquidExtent extent = Extent(new Vector3(0f, 0.5f, 0f), Vector3.one);
            var force = new FluidBodyForce { RateSquared = new Vector3(9f, 16f, 0f) };
            Assert.That(extent.SpeedBy(force), Is.EqualTo(Mathf.Sqrt(18.25f)).Within(1e-5f));
            force.Centre = new Vector3(0f, 1f, 0f);
            Assert.That(extent.SpeedBy(force), Is.EqualTo(Mathf.Sqrt(18.25f)).Within(1e-5f), "the cube's foot is as far away");
            force = new FluidBodyForce { RateSquared = new Vector3(0f, 0f, -4f), Centre = new Vector3(0f, 0f, 1f) };
            Assert.That(extent.SpeedBy(force), Is.EqualTo(2f * 3f).Within(1e-5f), "pushed to the far face, 3 m from the centre");
            Assert.That(extent.SpeedBy(default), Is.Zero);
        }

        private static LiquidExtent Extent(Vector3 center, Vector3 size) =>
            LiquidExtent.Create(new[] { new LiquidBox("box", Matrix4x4.TRS(center, Quaternion.identity, size), Vector3.zero) }, Domain);
    }
}
