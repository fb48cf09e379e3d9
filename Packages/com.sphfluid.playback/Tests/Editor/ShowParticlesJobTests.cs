using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Collections;
using Unity.Jobs;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Particles between two frames, against motion that is known.</summary>
    public sealed class ShowParticlesJobTests
    {
        private static readonly Vector3 Half = 10f * Vector3.one;
        private static readonly int[] Counts = { 0, 1, 257, 1009 };

        [Test]
        public void CubicMotionIsMetExactly([ValueSource(nameof(Counts))] int count, [Values(0.25f, 0.5f, 0.875f)] float share)
        {
            const float duration = 0.5f;
            StoredParticle[] from = At(0.0, count), to = At(duration, count), expected = At(share * duration, count);
            FluidParticle[] shown = Show(from, to, share, duration, out int[] counts);
            Assert.That(counts, Is.EqualTo(new[] { count, 0, 0 }));
            for (int i = 0; i < count; i++)
            {
                Assert.That((shown[i].Position - expected[i].Position).magnitude, Is.LessThan(2e-6f), $"position of {i}");
                Assert.That((shown[i].VelT0 - expected[i].Velocity).magnitude, Is.LessThan(2e-5f), $"velocity of {i}");
                Assert.That((shown[i].Id, shown[i].Removed, shown[i].VelT1), Is.EqualTo((expected[i].Id, 0f, shown[i].VelT0)));
            }
        }

        [Test]
        public void ACircleIsFollowedToTheFourthOrder()
        {
            double Error(double duration)
            {
                StoredParticle At(double t) => new StoredParticle
                {
                    Position = new Vector3((float)Math.Cos(t), (float)Math.Sin(t), 0f),
                    Velocity = new Vector3((float)-Math.Sin(t), (float)Math.Cos(t), 0f),
                };
                FluidParticle shown = Show(new[] { At(0.0) }, new[] { At(duration) }, 0.5f, (float)duration, out _)[0];
                return (shown.Position - At(0.5 * duration).Position).magnitude;
            }
            Assert.That(Error(0.8), Is.LessThan(0.8 * 0.8 * 0.8 * 0.8 / 384 * 1.1));
            Assert.That(Error(0.8) / Error(0.4), Is.EqualTo(16.0).Within(1.0));
        }

        [Test]
        public void AtAFrameItsParticlesAreShownToTheBit([ValueSource(nameof(Counts))] int count)
        {
            StoredParticle[] from = At(0.3, count);
            if (count > 0) from[0].Velocity = new Vector3(-0f, 0f, -0f);
            FluidParticle[] shown = Show(from, At(0.9, 3), 0f, 0.6f, out int[] counts);
            Assert.That(counts[ShowParticlesJob.Shown], Is.EqualTo(count));
            for (int i = 0; i < count; i++)
            {
                Assert.That(Bits(shown[i].Position), Is.EqualTo(Bits(from[i].Position)));
                Assert.That(Bits(shown[i].VelT0), Is.EqualTo(Bits(from[i].Velocity)));
            }
        }

        [TestCase(0.25f, "1 2 4 6")]
        [TestCase(0.49f, "1 2 4 6")]
        [TestCase(0.5f, "2 3 4 7 8")]
        [TestCase(0.75f, "2 3 4 7 8")]
        public void ThoseOfOneFrameOnlyAreThereUpToTheMiddle(float share, string expected)
        {
            StoredParticle Of(uint id, float x) =>
                new StoredParticle { Id = id, Position = new Vector3(x, 0f, 0f), Velocity = new Vector3(2f, 0f, 0f) };
            var from = new[] { Of(1, 0f), Of(2, 0f), Of(4, 0f), Of(6, 0f) };
            var to = new[] { Of(2, 2f), Of(3, 2f), Of(4, 2f), Of(7, 2f), Of(8, 2f) };
            FluidParticle[] shown = Show(from, to, share, 1f, out int[] counts);
            Assert.That(string.Join(" ", shown.Take(counts[0]).Select(p => p.Id)), Is.EqualTo(expected));
            foreach (FluidParticle particle in shown.Take(counts[0]))
            {
                Assert.That(particle.Position.x, Is.EqualTo(2f * share).Within(1e-6f), $"{particle.Id}");
            }
        }

        [Test]
        public void WithoutVelocitiesTheyGoStraight()
        {
            var from = new[] { new StoredParticle { Position = new Vector3(1f, 2f, 3f) } };
            var to = new[] { new StoredParticle { Position = new Vector3(2f, 0f, 3f) } };
            FluidParticle shown = Show(from, to, 0.25f, 0.5f, out _, SequenceBlend.Linear)[0];
            Assert.That(shown.Position, Is.EqualTo(new Vector3(1.25f, 1.5f, 3f)));
            Assert.That(shown.VelT0, Is.EqualTo(new Vector3(2f, -4f, 0f)));
        }

        [Test]
        public void WhatIsOutsideOrNoNumberIsCountedAndLeftOut([Values(0f, 0.5f)] float share)
        {
            StoredParticle Of(uint id, Vector3 position, Vector3 velocity = default) =>
                new StoredParticle { Id = id, Position = position, Velocity = velocity };
            var particles = new[]
            {
                Of(0, Vector3.zero), Of(1, new Vector3(10.01f, 0f, 0f)), Of(2, new Vector3(float.NaN, 0f, 0f)),
                Of(3, Vector3.zero, new Vector3(0f, float.PositiveInfinity, 0f)),
                Of(4, 10f * Vector3.one), Of(5, new Vector3(0f, 0f, -11f)),
            };
            FluidParticle[] shown = Show(particles, particles, share, 1f, out int[] counts);
            Assert.That(counts, Is.EqualTo(new[] { 2, 2, 2 }));
            Assert.That(shown.Take(2).Select(p => p.Id), Is.EqualTo(new[] { 0u, 4u }));
        }

        [Test]
        public void InterpolationCarriesNobodyThroughAFace()
        {
            var from = new[] { new StoredParticle { Position = new Vector3(9.9f, 0f, 0f), Velocity = new Vector3(5f, 0f, 0f) } };
            var to = new[] { new StoredParticle { Position = new Vector3(9.9f, 0f, 0f), Velocity = new Vector3(-5f, 0f, 0f) } };
            FluidParticle shown = Show(from, to, 0.5f, 1f, out int[] counts)[0];
            Assert.That(counts, Is.EqualTo(new[] { 1, 0, 0 }));
            Assert.That(shown.Position.x, Is.EqualTo(10f));
        }

        [TestCase(0.25f, 9.75f)]
        [TestCase(0.75f, -9.75f)]
        public void ThroughAPeriodicFaceTheyGoTheShortWay(float share, float expected)
        {
            var from = new[] { new StoredParticle { Position = new Vector3(9.5f, 1f, 0f), Velocity = new Vector3(1f, 0f, 0f) } };
            var to = new[] { new StoredParticle { Position = new Vector3(-9.5f, 1f, 0f), Velocity = new Vector3(1f, 0f, 0f) } };
            FluidParticle shown = Show(from, to, share, 1f, out _, SequenceBlend.Hermite, new Vector3(20f, 0f, 0f))[0];
            Assert.That(shown.Position.x, Is.EqualTo(expected).Within(1e-5f));
            Assert.That(shown.VelT0.x, Is.EqualTo(1f).Within(1e-5f));
        }

        // Cubics of time, another one for each particle and axis.
        private static StoredParticle[] At(double t, int count)
        {
            var random = new System.Random(41);
            double Next() => random.NextDouble() - 0.5;
            var particles = new StoredParticle[count];
            for (int i = 0; i < count; i++)
            {
                var particle = new StoredParticle { Id = (uint)(5 * i + 2) };
                for (int axis = 0; axis < 3; axis++)
                {
                    (double a, double b, double c, double d) = (Next(), Next(), Next(), Next());
                    particle.Position[axis] = (float)(a + t * (b + t * (c + t * d)));
                    particle.Velocity[axis] = (float)(b + t * (2.0 * c + t * 3.0 * d));
                }
                particles[i] = particle;
            }
            return particles;
        }

        private static (int, int, int) Bits(Vector3 v) =>
            (BitConverter.SingleToInt32Bits(v.x), BitConverter.SingleToInt32Bits(v.y), BitConverter.SingleToInt32Bits(v.z));

        private static FluidParticle[] Show(StoredParticle[] from, StoredParticle[] to, float share, float duration, out int[] counts,
            SequenceBlend blend = SequenceBlend.Hermite,
            Vector3 period = default)
        {
            using (var first = new NativeArray<StoredParticle>(from, Allocator.TempJob))
            using (var second = new NativeArray<StoredParticle>(to, Allocator.TempJob))
            using (var shown = new NativeArray<FluidParticle>(Math.Max(1, Math.Max(from.Length, to.Length)), Allocator.TempJob))
            using (var counted = new NativeArray<int>(ShowParticlesJob.CountLength, Allocator.TempJob))
            {
                new ShowParticlesJob
                {
                    From = first,
                    To = second,
                    FromCount = from.Length,
                    ToCount = to.Length,
                    Share = share,
                    Duration = duration,
                    Blend = blend,
                    Half = Half,
                    Period = period,
                    Particles = shown,
                    Counts = counted,
                }.Run();
                counts = counted.ToArray();
                return shown.ToArray();
            }
        }
    }
}
