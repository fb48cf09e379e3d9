using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Crates in still water, against Archimedes.</summary>
    public sealed class FloatingCrateTests
    {
        // Three halves as wide as high, let go a little above its draught and tilted.
        // Any force that is a frame late makes the light one diverge: it carries three times its mass of water along.
        [TestCase(0.1f)] // FloatingRigidbodyTests has a heavier one
        public void ACrateFloatsUprightAsDeepAsItIsHeavy(float ratio)
        {
            using (var tank = new FloatingTank(0.06f, 13, 9, 0.3f * new Vector3(1.5f, 1f, 1.5f), ratio, 0.3f * (0.55f - ratio),
                Quaternion.Euler(5f, 0f, 3f)))
            {
                tank.Play(1.3);
                string figures = tank.Figures(0.5);
                Assert.That(tank.Tilt, Is.LessThan(8.0), figures);
                Assert.That(tank.Draught(0.5), Is.EqualTo(ratio).Within(0.3 * 0.06 / 0.3), figures); // 0.3 dx
                Assert.That(tank.Speed(0.5), Is.LessThan(0.06), figures);
            }
        }
    }
}
