using System;
using NUnit.Framework;
using UnityEngine;
using Random = System.Random;

namespace SphFluid.Tests
{
    /// <summary>The measure against closed forms of its formula.</summary>
    public sealed class StructuralSimilarityTests
    {
        private const int Width = 24;
        private const int Height = 20;
        private const double C1 = 1e-4;
        private const double C2 = 9e-4;

        [Test]
        public void EqualPicturesHaveOne()
        {
            Picture noise = Noise(1);
            Assert.That(StructuralSimilarity.Of(noise, noise), Is.EqualTo(1.0).Within(1e-12));
        }

        [TestCase(0.2f, 0.8f)]
        [TestCase(0f, 1f)]
        [TestCase(0.5f, 0.52f)]
        public void EvenPicturesDifferByTheirMeans(float a, float b)
        {
            double expected = (2.0 * a * b + C1) / ((double)a * a + (double)b * b + C1);
            Assert.That(StructuralSimilarity.Of(Grey((x, y) => a), Grey((x, y) => b)), Is.EqualTo(expected).Within(1e-6));
        }

        // About grey, the variance stays and the covariance changes its sign: a checkerboard's is 0.2^2 in any window.
        [Test]
        public void InvertedContrastIsNegative()
        {
            Picture board = Grey((x, y) => (x + y) % 2 == 0 ? 0.7f : 0.3f), inverse = Grey((x, y) => (x + y) % 2 == 0 ? 0.3f : 0.7f);
            double expected = (-2.0 * 0.04 + C2) / (2.0 * 0.04 + C2);
            Assert.That(StructuralSimilarity.Of(board, inverse), Is.EqualTo(expected).Within(1e-3));
        }

        // Half the contrast about the same mean: 2 s t / (s^2 + t^2) with t = s / 2.
        [Test]
        public void LessContrastIsLessAlike()
        {
            Picture board = Grey((x, y) => (x + y) % 2 == 0 ? 0.7f : 0.3f), faint = Grey((x, y) => (x + y) % 2 == 0 ? 0.6f : 0.4f);
            double expected = (2.0 * 0.2 * 0.1 + C2) / (0.04 + 0.01 + C2);
            Assert.That(StructuralSimilarity.Of(board, faint), Is.EqualTo(expected).Within(1e-3));
        }

        [Test]
        public void NoiseIsUnlikeOtherNoiseWhicheverComesFirst()
        {
            Picture one = Noise(1), two = Noise(2);
            Assert.That(Math.Abs(StructuralSimilarity.Of(one, two)), Is.LessThan(0.15));
            Assert.That(StructuralSimilarity.Of(two, one), Is.EqualTo(StructuralSimilarity.Of(one, two)).Within(1e-12));
        }

        // Windows are 11 pixels wide: of those along a row, 5 pixels away is the last that sees a change, and it sees the least of it.
        [Test]
        public void AWindowSeesFivePixelsAround()
        {
            Picture even = Grey((x, y) => 0.5f), spot = Grey((x, y) => x == 12 && y == 10 ? 1f : 0.5f);
            double before = 0.0;
            for (int away = 0; away <= 5; away++)
            {
                double seen = StructuralSimilarity.At(even, spot, 12 - away, 10);
                Assert.That(seen, Is.LessThan(1.0).And.GreaterThan(before), $"{away} pixels away");
                before = seen;
            }
            Assert.That(StructuralSimilarity.At(even, spot, 6, 10), Is.EqualTo(1.0).Within(1e-12));
        }

        [Test]
        public void ColoursCountByTheirBrightness()
        {
            Picture green = Even(Color.green), grey = Even(new Color(0.587f, 0.587f, 0.587f));
            Assert.That(StructuralSimilarity.Of(green, grey), Is.EqualTo(1.0).Within(1e-6));
            Assert.That(StructuralSimilarity.Of(green, Even(Color.blue)), Is.LessThan(0.5));
        }

        [Test]
        public void SizesMustBeEqual() => Assert.That(() => StructuralSimilarity.Of(Noise(1), Noise(1).Halved()), Throws.ArgumentException);

        private static Picture Noise(int seed)
        {
            var random = new Random(seed);
            return Grey((x, y) => (float)random.NextDouble());
        }

        private static Picture Even(Color colour)
        {
            var pixels = new Color[Width * Height];
            for (int i = 0; i < pixels.Length; i++) pixels[i] = colour;
            return new Picture(Width, Height, pixels);
        }

        private static Picture Grey(Func<int, int, float> grey)
        {
            var pixels = new Color[Width * Height];
            for (int i = 0; i < pixels.Length; i++)
            {
                float value = grey(i % Width, i / Width);
                pixels[i] = new Color(value, value, value);
            }
            return new Picture(Width, Height, pixels);
        }
    }
}
