using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class CaseLatticeTests
    {
        [Test]
        public void BoxFillsItsVolumeFromItsCorner()
        {
            List<Vector3> box = CaseLattice.Box(new Vector3Int(2, 3, 5), 0.1, new Vector3(1, 2, 3));

            Assert.That(box.Distinct().Count(), Is.EqualTo(30));
            Assert.That(box[0], Is.EqualTo(new Vector3(1.05f, 2.05f, 3.05f)));
            Assert.That(Vector3.Distance(box[29], new Vector3(1.15f, 2.25f, 3.45f)), Is.LessThan(1e-6f));
        }

        [TestCase(4)]
        [TestCase(5)]
        [TestCase(8)]
        public void BallIsSymmetricAndHasAboutItsVolume(int resolution)
        {
            List<Vector3> ball = CaseLattice.Ball(1, 1.0 / resolution);
            var places = new HashSet<Vector3>(ball);

            Assert.That(ball.Count, Is.EqualTo(4.0 / 3.0 * Math.PI * resolution * resolution * resolution).Within(8).Percent);
            foreach (Vector3 p in ball)
            {
                Assert.That(p.magnitude, Is.LessThanOrEqualTo(1.00001f));
                Assert.That(places.Contains(-p) && places.Contains(new Vector3(p.y, p.x, p.z)) &&
                    places.Contains(new Vector3(p.z, p.y, -p.x)), p.ToString());
            }
        }

        [Test]
        public void JitterIsNormalAndFollowsTheSeed()
        {
            List<Vector3> Jittered(int seed)
            {
                List<Vector3> list = Enumerable.Repeat(Vector3.zero, 4001).ToList();
                CaseLattice.Jitter(list, 0.02, seed, Vector3.one);
                return list;
            }

            List<Vector3> first = Jittered(1);
            List<float> numbers = first.SelectMany(p => new[] { p.x, p.y, p.z }).ToList();
            double deviation = Math.Sqrt(numbers.Average(n => (double)n * n));
            Assert.That(numbers.Average(), Is.EqualTo(0).Within(1e-3));
            Assert.That(deviation, Is.EqualTo(0.02).Within(3).Percent);
            Assert.That(numbers.Count(n => Math.Abs(n) < 0.02) / (double)numbers.Count, Is.EqualTo(0.6827).Within(0.015),
                "one standard deviation");
            Assert.That(Jittered(1), Is.EqualTo(first));
            Assert.That(Jittered(2), Is.Not.EqualTo(first));
        }

        [Test]
        public void JitterKeepsInside()
        {
            List<Vector3> list = Enumerable.Repeat(new Vector3(0.5f, 0, -0.5f), 97).ToList();
            CaseLattice.Jitter(list, 0.1, 1, new Vector3(0.5f, 0.05f, 0.5f));

            Assert.That(list.All(p => Mathf.Abs(p.x) <= 0.5f && Mathf.Abs(p.y) <= 0.05f && Mathf.Abs(p.z) <= 0.5f));
            Assert.That(list.Any(p => p.x < 0.5f));
        }

        [Test]
        public void ParticlesAreNumberedAndMove()
        {
            FluidParticle[] particles = CaseLattice.Particles(new[] { Vector3.up, Vector3.right }, p => 2 * p);

            Assert.That(particles.Select(p => p.Id), Is.EqualTo(new uint[] { 0, 1 }));
            Assert.That(particles[1].VelT0, Is.EqualTo(2 * Vector3.right));
            Assert.That(particles[1].VelT1, Is.EqualTo(2 * Vector3.right));
        }
    }
}
