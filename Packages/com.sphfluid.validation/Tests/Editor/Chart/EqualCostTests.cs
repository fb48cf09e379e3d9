using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Points are made up; those of a method are identified by their κ.</summary>
    public sealed class EqualCostTests
    {
        private static readonly FlatCase flat = new FlatCase("flat");

        private ChartRows table;

        [SetUp]
        public void SetUp() => table = new ChartRows("device");

        [Test]
        public void InterpolatesBothAxesAsLogarithms()
        {
            Add("thesis", 2.0, 100, 0.4);
            Add("thesis", 2.5, 400, 0.1);
            Add("standard", 2.0, 200, 0.05); // between 100 and 400 as between 0.4 and 0.1: 0.2

            EqualCost.Comparison at = One("standard", 2.0);

            Assert.That(at.OtherError, Is.EqualTo(0.2).Within(1e-12));
            Assert.That(at.Ratio, Is.EqualTo(0.25).Within(1e-12));
            Assert.That(at.IsBound, Is.False);
        }

        [Test]
        public void APointOfEqualTimeIsComparedWithItself()
        {
            Add("thesis", 2.0, 100, 0.4);
            Add("thesis", 2.5, 400, 0.1);
            Add("standard", 2.0, 100, 0.2);
            Add("standard", 2.5, 400, 0.2);

            Assert.That(One("standard", 2.0).OtherError, Is.EqualTo(0.4).Within(1e-12));
            Assert.That(All().Where(c => c.Point.Method == "thesis").Select(c => c.OtherError), Is.All.EqualTo(0.2),
                "no better by being dearer");
        }

        [Test]
        public void BeyondTheOthersDearestPointItsErrorIsABound()
        {
            Add("thesis", 2.0, 100, 0.4);
            Add("thesis", 2.5, 400, 0.1);
            Add("standard", 2.0, 1000, 0.05);

            EqualCost.Comparison at = One("standard", 2.0);

            Assert.That((at.OtherError, at.IsBound), Is.EqualTo((0.1, true)));
        }

        [Test]
        public void BelowTheOthersCheapestPointThereIsNothingToCompareWith()
        {
            Add("thesis", 2.0, 100, 0.4);
            Add("standard", 2.0, 50, 0.1);

            Assert.That(All().Select(c => c.Point.Method), Is.EqualTo(new[] { "thesis" }));
        }

        [Test]
        public void OnlyPointsOfTheFrontsCount()
        {
            Add("thesis", 2.0, 100, 0.4);
            Add("thesis", 2.25, 200, 0.8); // dearer and worse
            Add("thesis", 2.5, 400, 0.1);
            Add("standard", 2.0, 200, 0.05);
            Add("standard", 2.5, 300, 0.5);

            Assert.That(One("standard", 2.0).OtherError, Is.EqualTo(0.2).Within(1e-12));
            Assert.That(All().Any(c => c.Point.SupportRatio == 2.25 || c.Point.Method == "standard" && c.Point.SupportRatio == 2.5),
                Is.False);
        }

        // FlatCase's floor is 0.04.
        [TestCase(0.01, 0.02, 1.0)]
        [TestCase(0.01, 0.08, 0.5)]
        [TestCase(0.12, 0.02, 3.0)]
        public void ErrorsBelowTheFloorAreEqual(double own, double other, double ratio)
        {
            Add("thesis", 2.0, 100, other);
            Add("standard", 2.0, 100, own);

            Assert.That(One("standard", 2.0, flat.Floor).Ratio, Is.EqualTo(ratio).Within(1e-12));
        }

        // Between +4 % and −2 % an error is 0.2 %; a fine spacing that errs a quarter more than a coarse one is no sign of that.
        [TestCase(0.002, 0.5)]
        [TestCase(0.016, 0.625)]
        public void ACoarsePointWhoseFinerOneErrsMoreIsGoodByChance(double coarse, double ratio)
        {
            Add("thesis", 2.0, 100, coarse, 6);
            Add("thesis", 2.0, 400, 0.02);
            Add("standard", 2.0, 400, 0.01);

            Assert.That(One("standard", 2.0).Ratio, Is.EqualTo(ratio).Within(1e-12));
        }

        [Test]
        public void LinesSayBothPoints()
        {
            Add("thesis", 2.0, 100, 0.4);
            Add("standard", 2.0, 200, 0.1);

            Assert.That(EqualCost.Format.Lines(All()), Is.EqualTo(new[]
            {
                "case,error_name,method,dx,kappa,dt_fraction,c_or_iterations,gpu_ms_per_sim_s,error,other_method,other_error,ratio," +
                "other_is,device,date",
                "flat,height,standard,0.0833333,2,0.5,5,200,0.1,thesis,0.4,0.25,its dearest,device,2026-11-22",
            }));
        }

        private EqualCost.Comparison One(string method, double kappa, double floor = 0.0) =>
            All(floor).Single(c => c.Point.Method == method && c.Point.SupportRatio == kappa);

        private IReadOnlyList<EqualCost.Comparison> All(double floor = 0.0) =>
            EqualCost.Of(ChartPoint.Of(table.Rows, "flat", "height"), floor);

        private void Add(string method, double kappa, double cost, double error, int resolution = 12)
        {
            CaseParameters parameters = flat.Base(CaseMethod.Find(method));
            parameters.Resolution = resolution;
            parameters.SupportRatio = kappa;
            table.Add(new ChartRun(new ChartConfig(flat, parameters, ChartFactor.Support), 1), FlatCase.Result(cost, error), "2026-11-22");
        }
    }
}
