using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class MeanCurveTests
    {
        [Test]
        public void MeansOverOtherIntervalsAreThoseOfTheIntegral()
        {
            var curve = new MeanCurve(1.0, 1.0, new[] { 1.0, 3.0, -2.0 });

            Assert.That(curve.Mean(2.0, 1.0), Is.EqualTo(2.0).Within(1e-12), "half of 1 and half of 3");
            Assert.That(curve.Mean(2.5, 3.0), Is.EqualTo(2.0 / 3.0).Within(1e-12));
            Assert.That(curve.Integral(2.5), Is.EqualTo(2.5).Within(1e-12));
            Assert.That(curve.TimeOf(2.5), Is.EqualTo(2.5).Within(1e-12));
            Assert.That(curve.TimeOf(9.0), Is.NaN);
            Assert.That(curve.Mean(1.4, 1.0), Is.NaN, "it begins at 1");
            Assert.That(curve.Mean(3.6, 1.0), Is.NaN, "it ends at 4");
        }

        [Test]
        public void ACurveHasItsMeansInTheMiddles()
        {
            var curve = new MeanCurve(0.0);
            curve.Add(0.5, 4.0);
            curve.Add(2.5, 1.0);
            CaseSeries all = curve.ToSeries("p", 0.0), late = curve.ToSeries("p", 0.5);

            Assert.That(all.X.Zip(all.Y, (x, y) => (x, y)), Is.EqualTo(new[] { (0.25, 4.0), (1.5, 1.0) }));
            Assert.That(late.X.Zip(late.Y, (x, y) => (x, y)), Is.EqualTo(new[] { (1.5, 1.0) }));
        }
    }
}
