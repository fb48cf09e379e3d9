using System.Collections.Generic;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class LiquidReachTests
    {
        private const int Row = 4;
        private const double Spacing = 0.5;

        [TestCase(1)]
        [TestCase(2)]
        [TestCase(11)]
        public void ALatticeReachesHalfASpacingBeyondItsLastRow(int rows)
        {
            LiquidReach reach = LiquidReach.Of(Rows(rows), Row, Spacing);

            Assert.That(reach.Edge, Is.EqualTo(rows * Spacing).Within(1e-12));
            Assert.That(reach.Count, Is.EqualTo(rows * Row));
        }

        [Test]
        public void SprayDoesNotCount([Range(1, Row - 1)] int flying, [Values(1.6, 2.5, 9.0)] double ahead)
        {
            List<double> distances = Rows(6);
            for (int i = 0; i < flying; i++) distances.Add((5.5 + ahead) * Spacing);

            LiquidReach reach = LiquidReach.Of(distances, Row, Spacing);

            // Nearer than two spacings to the last row it is still liquid: the mean of the last row moves a little.
            double mean = ahead < 2.0 ? 5.5 + ahead * flying / Row : 5.5;
            Assert.That(reach.Edge, Is.EqualTo((mean + 0.5) * Spacing).Within(1e-12));
            Assert.That(reach.Count, Is.EqualTo(6 * Row + (ahead < 2.0 ? flying : 0)));
        }

        [Test]
        public void ARowThatIsNearIsLiquidAndOneThatIsFarIsNot()
        {
            List<double> near = Rows(6), far = Rows(6);
            for (int i = 0; i < Row; i++)
            {
                near.Add((5.5 + 1.9) * Spacing);
                far.Add((5.5 + 2.1) * Spacing);
            }

            Assert.That(LiquidReach.Of(near, Row, Spacing).Edge, Is.EqualTo((5.5 + 1.9 + 0.5) * Spacing).Within(1e-12));
            Assert.That(LiquidReach.Of(far, Row, Spacing).Edge, Is.EqualTo(6 * Spacing).Within(1e-12));
        }

        [Test]
        public void WithoutLiquidAtTheWallThereIsNoReach()
        {
            Assert.That(LiquidReach.Of(new List<double>(), Row, Spacing).Edge, Is.Zero);
            Assert.That(LiquidReach.Of(new List<double> { 1.1, 1.2, 1.2, 1.3, 1.4 }, Row, Spacing).Edge, Is.Zero);
            Assert.That(LiquidReach.Of(new List<double> { 0.2 }, Row, Spacing).Count, Is.EqualTo(1));
        }

        // Shuffled: the order must not matter.
        private static List<double> Rows(int rows)
        {
            var distances = new List<double>();
            for (int i = 0; i < Row; i++)
                for (int row = rows - 1; row >= 0; row--) distances.Add((row + 0.5) * Spacing);
            return distances;
        }
    }
}
