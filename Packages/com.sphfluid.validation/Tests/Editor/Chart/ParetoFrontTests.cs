using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Points are identified by their κ; every one has three seeds around its median.</summary>
    public sealed class ParetoFrontTests
    {
        private static readonly FlatCase flat = new FlatCase("flat");

        [Test]
        public void KeepsWhatNothingBeats()
        {
            // κ 2 is dearer and worse than 1.75; 3 is dear but best.
            Assert.That(Front((1.75, 100, 1, 0.10, 0.001), (2.0, 150, 1, 0.12, 0.001), (2.5, 200, 1, 0.05, 0.001),
                (3.0, 400, 1, 0.01, 0.001)),
                Is.EqualTo(new[] { 1.75, 2.5, 3.0 }));
        }

        [Test]
        public void ADifferenceWithinTheBarsDoesNotBeat()
        {
            // Half-bars of 10 and 10 ms/s: 15 is within, 25 beyond.
            Assert.That(Front((2.0, 100, 10, 0.1, 0.0), (2.5, 115, 10, 0.1, 0.0)), Is.EqualTo(new[] { 2.0, 2.5 }));
            Assert.That(Front((2.0, 90, 10, 0.1, 0.0), (2.5, 115, 10, 0.1, 0.0)), Is.EqualTo(new[] { 2.0 }));
            Assert.That(Front((2.0, 100, 0, 0.10, 0.01), (2.5, 100, 0, 0.115, 0.01)), Is.EqualTo(new[] { 2.0, 2.5 }));
            Assert.That(Front((2.0, 100, 0, 0.09, 0.01), (2.5, 100, 0, 0.115, 0.01)), Is.EqualTo(new[] { 2.0 }));
        }

        [Test]
        public void EqualPointsBothStay() =>
            Assert.That(Front((2.0, 100, 0, 0.1, 0.0), (2.5, 100, 0, 0.1, 0.0)), Is.EqualTo(new[] { 2.0, 2.5 }));

        [Test]
        public void ADearerPointBeatsNothingHoweverWideItsBars() =>
            Assert.That(Front((2.0, 100, 50, 0.2, 0.0), (2.5, 101, 50, 0.1, 0.0)), Is.EqualTo(new[] { 2.0, 2.5 }));

        [Test]
        public void APointWithAFailedSeedIsNotOnTheFront()
        {
            var rows = new ChartRows("device");
            Add(rows, 2.0, 100, 1, 0.1, 0.001);
            Add(rows, 2.5, 50, 1, 0.05, 0.001);
            rows.Add(Run(2.5, 2), FlatCase.Result(50, 0.0, "energy grew"), "2026-11-21");
            IReadOnlyList<ChartPoint> points = ChartPoint.Of(rows.Rows, "flat", "height");

            Assert.That(points.Single(p => p.SupportRatio == 2.5).Failures, Is.EqualTo(1));
            Assert.That(ParetoFront.Of(points).Select(p => p.SupportRatio), Is.EqualTo(new[] { 2.0 }));
        }

        [Test]
        public void PointsHaveMedianAndBars()
        {
            var rows = new ChartRows("device");
            Add(rows, 2.0, 100, 10, 0.1, 0.02);
            ChartPoint point = ChartPoint.Of(rows.Rows, "flat", "height").Single();
            ChartPoint drift = ChartPoint.Of(rows.Rows, "flat", "drift").Single();

            Assert.That(point.Seeds, Is.EqualTo(3));
            Assert.That(point.Cost.Value.Median, Is.EqualTo(100));
            Assert.That(point.Cost.Value.Maximum, Is.EqualTo(110));
            Assert.That(point.Error.Value.Minimum, Is.EqualTo(0.08).Within(1e-12));
            Assert.That(drift.Error.Value.Median, Is.EqualTo(0.01).Within(1e-12), "magnitude of -0.01");
        }

        [Test]
        public void LinesHaveMediansAndHalfBars()
        {
            var rows = new ChartRows("device");
            Add(rows, 2.0, 100, 10, 0.1, 0.02);

            Assert.That(ParetoFront.Format.Lines(ParetoFront.Of(ChartPoint.Of(rows.Rows, "flat", "height"))).Last(),
                Is.EqualTo("flat,thesis,0.0833333,2,0.5,5,1728,3,100,10,0.1,0.02,height,device,2026-11-21"));
        }

        private static double[] Front(params (double Kappa, double Cost, double CostBar, double Error, double ErrorBar)[] points)
        {
            var rows = new ChartRows("device");
            foreach ((double kappa, double cost, double costBar, double error, double errorBar) in points)
            {
                Add(rows, kappa, cost, costBar, error, errorBar);
            }
            return ParetoFront.Of(ChartPoint.Of(rows.Rows, "flat", "height")).Select(p => p.SupportRatio).OrderBy(k => k).ToArray();
        }

        private static void Add(ChartRows rows, double kappa, double cost, double costBar, double error, double errorBar)
        {
            for (int seed = 1; seed <= 3; seed++)
            {
                rows.Add(Run(kappa, seed), FlatCase.Result(cost + (seed - 2) * costBar, error + (seed - 2) * errorBar), "2026-11-21");
            }
        }

        private static ChartRun Run(double kappa, int seed)
        {
            CaseParameters parameters = flat.Base(CaseMethod.Find("thesis"));
            parameters.SupportRatio = kappa;
            return new ChartRun(new ChartConfig(flat, parameters, ChartFactor.Support), seed);
        }
    }
}
