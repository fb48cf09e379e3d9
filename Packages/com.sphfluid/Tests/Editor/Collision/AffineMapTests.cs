using NUnit.Framework;

namespace SphFluid.Tests
{
    public sealed class AffineMapTests
    {
        private static AffineMap Linear(double[] m) => new AffineMap(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]);

        [Test]
        public void TheDifferenceIsThatOfTheElementsThatDifferMost(
            [NUnit.Framework.Range(0, 8)] int element, [Values(-3.0, 3.0)] double change)
        {
            double[] one = { 1, -2, 3, 4, 5, -6, 7, 8, -9 }, other = { 2, -1, 2, 5, 4, -5, 6, 9, -8 };
            other[element] = one[element] + change;
            Assert.That(AffineMap.Difference(Linear(one), Linear(other)), Is.EqualTo(3.0));
            Assert.That(AffineMap.Difference(Linear(other), Linear(one)), Is.EqualTo(3.0));
        }
    }
}
