using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The speed that a body force gives goes with the distance from its centre, wherever that is.</summary>
    public sealed class BodyForceReachTests
    {
        // A cube of 1 m around (0, 0.5, 0) in a domain of 2 x 3 x 4 m: its corners are 1.5 m from y = -0.5 and 2 m from y = -1.
        [TestCase(0.5f, 0.5f)]
        [TestCase(0f, 1f)]
        [TestCase(-0.5f, 1.5f)]
        [TestCase(-1f, 2f)]
        [TestCase(1.5f, 1.5f)]
        public void TheFarthestCornerCounts(float centre, float distance)
        {
            var box = new LiquidBox("box", Matrix4x4.TRS(new Vector3(0f, 0.5f, 0f), Quaternion.identity, Vector3.one), Vector3.zero);
            LiquidExtent extent = LiquidExtent.Create(new[] { box }, new Vector3(2f, 3f, 4f));
            var force = new FluidBodyForce { RateSquared = new Vector3(0f, 9f, 0f), Centre = new Vector3(0f, centre, 0f) };
            Assert.That(extent.SpeedBy(force), Is.EqualTo(3f * distance).Within(1e-5f));
        }
    }
}
