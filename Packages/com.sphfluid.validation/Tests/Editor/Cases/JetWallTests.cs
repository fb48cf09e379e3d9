using System;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class JetWallTests
    {
        [Test]
        public void TheStripsBearTheJetsMomentum()
        {
            // Over ½ρU² and b; beyond them is 1 %.
            double force = Enumerable.Range(0, JetWall.Strips).Sum(i => JetWall.Pressure(i)) * 2.0 * JetWall.Reach / JetWall.Strips;
            Assert.That(0.5 * force, Is.InRange(0.98, 1.0));
        }

        [Test]
        public void ThePressureIsThatOfTheStreamlines([Values(0, 3, 8, 13)] int strip)
        {
            // Over the strip, y by q: the mean of 1 − q².
            double sum = 0.0, count = 0.0, half = JetWall.Reach / JetWall.Strips, middle = Math.Abs(JetWall.Middle(strip));
            double before = 0.0;
            for (int i = 1; i <= 400000; i++)
            {
                double q = i / 400000.0 * 0.9999999, y = (2.0 * Math.Atan(q) + Math.Log((1.0 + q) / (1.0 - q))) / Math.PI;
                if (Math.Abs(0.5 * (y + before) - middle) < half)
                {
                    sum += (1.0 - q * q) * (y - before);
                    count += y - before;
                }
                before = y;
            }
            Assert.That(JetWall.Pressure(strip), Is.EqualTo(sum / count).Within(2e-4));
        }

        [Test]
        public void TheMiddleHasTheStagnationPressure() =>
            Assert.That(JetWall.Pressure(JetWall.Strips / 2),
                Is.EqualTo(JetWall.Pressure(JetWall.Strips / 2 - 1)).Within(1e-12).And.InRange(0.98, 1.0));

        [Test]
        public void PatchesLieOnTheWallSideBySide()
        {
            var domain = new Vector3(9f, 14f, 0.5f);
            var patches = JetWall.Patches(domain, 0.5);
            for (int i = 0; i < patches.Count; i++)
            {
                Assert.That(patches[i].Centre.x, Is.EqualTo(-4.5f));
                Assert.That(patches[i].Centre.y, Is.EqualTo(-1f + 0.125f * (i + 0.5f)).Within(1e-6f));
                Assert.That(patches[i].Size, Is.EqualTo(new Vector2(0.5f, 0.125f)));
                Assert.That(Vector3.Distance(patches[i].Rotation * Vector3.forward, Vector3.right), Is.LessThan(1e-6f));
                Assert.That(Vector3.Distance(patches[i].Rotation * Vector3.up, Vector3.up), Is.LessThan(1e-6f));
            }
        }
    }
}
