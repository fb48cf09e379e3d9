using System;
using System.Linq;
using NUnit.Framework;

namespace SphFluid.Tests
{
    public sealed class SpeedCountsTests
    {
        [Test]
        public void ABinIsBelowItsUpperEdgeAndNotBelowTheOneBefore()
        {
            var random = new Random(3);
            for (int i = 0; i < 2000; i++)
            {
                float square = (float)Math.Pow(2.0, 60.0 * random.NextDouble() - 38.0);
                int bin = SpeedCounts.BinOf(square);
                double speed = Math.Sqrt(square);
                Assert.That(SpeedCounts.UpperEdge(bin), Is.GreaterThan(speed * 0.9999999));
                Assert.That(SpeedCounts.UpperEdge(bin - 1), Is.LessThan(speed * 1.0000001));
                Assert.That(SpeedCounts.UpperEdge(bin), Is.LessThan(1.0607 * speed), "a bin is an eighth of its octave's start at most");
            }
        }

        [TestCase(0f, 0)]
        [TestCase(-0f, 0)]
        [TestCase(1e-20f, 0)]
        [TestCase(1f, 320)]
        [TestCase(1e30f, 511)]
        [TestCase(float.PositiveInfinity, 511)]
        [TestCase(float.NaN, 511)]
        public void EverySquareHasABin(float square, int bin)
        {
            Assert.That(SpeedCounts.BinOf(square), Is.EqualTo(bin));
        }

        [Test]
        public void AQuantileIsWhatAShareDoesNotExceed()
        {
            var counts = new uint[SpeedCounts.Size];
            counts[SpeedCounts.Heads + 100] = 990;
            counts[SpeedCounts.Heads + 200] = 9;
            counts[SpeedCounts.Heads + SpeedCounts.Bins - 1] = 1;
            Assert.That(SpeedCounts.Quantile(counts, SpeedCounts.Heads, 0.99), Is.EqualTo(SpeedCounts.UpperEdge(100)));
            Assert.That(SpeedCounts.Quantile(counts, SpeedCounts.Heads, 0.9901), Is.EqualTo(SpeedCounts.UpperEdge(200)));
            Assert.That(SpeedCounts.Quantile(counts, SpeedCounts.Heads, 1.0), Is.EqualTo(float.PositiveInfinity));
            Assert.That(SpeedCounts.Quantile(counts, SpeedCounts.Heads, 0.0), Is.EqualTo(SpeedCounts.UpperEdge(100)));
            Assert.That(SpeedCounts.Quantile(counts, SpeedCounts.Speeds, 0.99), Is.Zero, "none was counted");
        }

        [Test]
        public void OneDropDoesNotRaiseTheHead()
        {
            var counts = new uint[SpeedCounts.Size];
            counts[SpeedCounts.Heads + 300] = 200;
            counts[SpeedCounts.Heads + 400] = 2;
            counts[SpeedCounts.Fastest] = unchecked((uint)BitConverter.SingleToInt32Bits(7f));
            SpeedSample sample = SpeedSample.Evaluate(counts, 0, 0.0);
            Assert.That(sample.Head, Is.EqualTo(SpeedCounts.UpperEdge(300)));
            Assert.That(sample.Fastest, Is.EqualTo(7f));
            // What cannot fall is taken off, but never of the speed that is there.
            float head = SpeedCounts.UpperEdge(300);
            Assert.That(SpeedSample.Evaluate(counts, 0, 0.75 * head * head / 202).Head, Is.EqualTo(0.5f * head).Within(1e-5f * head));
            counts[100] = 202;
            Assert.That(SpeedSample.Evaluate(counts, 0, head * head / 202).Head, Is.EqualTo(SpeedCounts.UpperEdge(100)));
            Assert.That(new[] { float.NaN, float.PositiveInfinity, -1f }.Select(SpeedSample.Finite), Is.All.EqualTo(float.MaxValue));
        }
    }
}
