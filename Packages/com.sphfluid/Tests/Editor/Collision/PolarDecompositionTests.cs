using System;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Rotation and stretch of linear maps, and the range of stretches, against their definitions.</summary>
    public sealed class PolarDecompositionTests
    {
        private static AffineMap Random(System.Random random, double unevenness)
        {
            double Scale() => Math.Pow(10.0, unevenness * (2.0 * random.NextDouble() - 1.0));
            AffineMap Turn() => AffineMap.FromMatrix(Matrix4x4.Rotate(ParticleSets.RandomRotation(random)));
            return Turn() * new AffineMap(Scale(), 0, 0, 0, Scale(), 0, 0, 0, Scale()) * Turn();
        }

        private static double Size(in AffineMap m) => AffineMap.Difference(m, new AffineMap(0, 0, 0, 0, 0, 0, 0, 0, 0));

        [TestCase(0.0)]
        [TestCase(0.3)]
        [TestCase(3.0)]
        public void ARotationAfterAStretchIsTheMap(double unevenness)
        {
            var random = new System.Random(3);
            for (int i = 0; i < 500; i++)
            {
                AffineMap a = Random(random, unevenness);
                Assert.That(PolarDecomposition.TryFind(a, out PolarDecomposition parts), Is.True);
                AffineMap r = parts.Rotation, s = parts.Stretch;
                Assert.That(AffineMap.Difference(r.Transpose * r, AffineMap.Identity), Is.LessThan(1e-12), "a rotation");
                Assert.That(r.Determinant, Is.EqualTo(1.0).Within(1e-12));
                Assert.That(AffineMap.Difference(s, s.Transpose), Is.Zero, "symmetric");
                Assert.That(AffineMap.Difference(r * s, a), Is.LessThan(1e-12 * Size(a)));
                // Sylvester: the leading minors of a positive definite matrix are positive.
                Assert.That(s.M00 > 0.0 && s.M00 * s.M11 - s.M01 * s.M10 > 0.0 && s.Determinant > 0.0);
                AffineMap turned = AffineMap.FromMatrix(Matrix4x4.Rotate(parts.Quaternion));
                Assert.That(AffineMap.Difference(turned, r), Is.LessThan(1e-6), "the quaternion is the rotation");
            }
        }

        [Test]
        public void MirroredFlatAndBrokenMapsHaveNone()
        {
            Assert.That(PolarDecomposition.TryFind(new AffineMap(-1, 0, 0, 0, 1, 0, 0, 0, 1), out _), Is.False, "mirrored");
            Assert.That(PolarDecomposition.TryFind(new AffineMap(1, 0, 0, 0, 1, 0, 0, 0, 0), out _), Is.False, "flat");
            Assert.That(PolarDecomposition.TryFind(new AffineMap(double.NaN, 0, 0, 0, 1, 0, 0, 0, 1), out _), Is.False);
            Assert.That(PolarDecomposition.TryFind(new AffineMap(-1, 0, 0, 0, -1, 0, 0, 0, 1), out PolarDecomposition half), Is.True,
                "half a turn");
            Assert.That(AffineMap.Difference(half.Stretch, AffineMap.Identity), Is.LessThan(1e-12));
        }

        // Of half a turn all but one of the four formulas of the quaternion divide zero by zero.
        [TestCase(1, -1, -1)]
        [TestCase(-1, 1, -1)]
        [TestCase(-1, -1, 1)]
        public void TheQuaternionOfHalfATurnIsItsAxis(int x, int y, int z)
        {
            Assert.That(PolarDecomposition.TryFind(new AffineMap(x, 0, 0, 0, y, 0, 0, 0, z), out PolarDecomposition parts), Is.True);
            Quaternion q = parts.Quaternion;
            var axis = new Vector3(Mathf.Abs(q.x), Mathf.Abs(q.y), Mathf.Abs(q.z));
            Assert.That(axis, Is.EqualTo(new Vector3(Mathf.Max(x, 0), Mathf.Max(y, 0), Mathf.Max(z, 0))));
            Assert.That(Mathf.Abs(q.w), Is.Zero);
        }

        [Test]
        public void TheInverseUndoesTheMapWithItsOffset()
        {
            var random = new System.Random(4);
            for (int i = 0; i < 100; i++)
            {
                AffineMap a = Random(random, 1.0).At(random.NextDouble(), -2.0, 30.0 * random.NextDouble());
                Vector3 p = ParticleSets.RandomVector(random);
                Assert.That((a.Inverse.Apply(a.Apply(p)) - p).magnitude, Is.LessThan(1e-4f));
                Assert.That(AffineMap.Difference(a * a.Inverse, AffineMap.Identity), Is.LessThan(1e-11));
            }
        }

        [Test]
        public void TheRangeOfAStretchHoldsTheLengthsOfUnitVectors()
        {
            var random = new System.Random(5);
            for (int i = 0; i < 200; i++)
            {
                PolarDecomposition.TryFind(Random(random, 0.5), out PolarDecomposition parts);
                BodyStretch stretch = BodyStretch.Create(parts.Stretch, BodyStretch.None);
                (double least, double most) = stretch.Range();
                double shortest = double.MaxValue, longest = 0.0;
                for (int k = 0; k < 2000; k++)
                {
                    double length = stretch.Map.Apply(ParticleSets.RandomVector(random).normalized).magnitude;
                    shortest = Math.Min(shortest, length);
                    longest = Math.Max(longest, length);
                }
                Assert.That(shortest, Is.GreaterThan(0.9999 * least).And.LessThan(1.2 * least));
                Assert.That(longest, Is.LessThan(1.0001 * most).And.GreaterThan(0.8 * most));
            }
        }

        // 3, 4 along the diagonal and 6 in both halves: the square root of 9 + 16 + 2 x 36.
        [Test]
        public void TheChangeOfAStretchIsTheNormOfTheDifference()
        {
            BodyStretch a = BodyStretch.Create(new AffineMap(2, 1, 0, 1, 7, 0, 0, 0, 1), BodyStretch.None);
            BodyStretch b = BodyStretch.Create(new AffineMap(5, 7, 0, 7, 3, 0, 0, 0, 1), BodyStretch.None);
            Assert.That(BodyStretch.Change(a, b), Is.EqualTo(Math.Sqrt(97.0)).Within(1e-6));
            Assert.That(BodyStretch.Change(b, a), Is.EqualTo(Math.Sqrt(97.0)).Within(1e-6));
            Assert.That(BodyStretch.Change(a, a), Is.Zero);
        }

        [Test]
        public void RoundingIsNoStretchAndASlowOneAddsUp()
        {
            BodyStretch stretch = BodyStretch.None;
            AffineMap Even(double s) => new AffineMap(s, 0, 0, 0, s, 0, 0, 0, s);
            stretch = BodyStretch.Create(Even(1.000002), stretch);
            Assert.That(stretch.IsNone, Is.True);
            for (int frame = 1; frame <= 10; frame++) stretch = BodyStretch.Create(Even(1.0 + 2e-6 * frame), stretch);
            Assert.That(stretch.Diagonal.x, Is.EqualTo(1.00002f).Within(1e-5f).And.GreaterThan(1f));
        }
    }
}
