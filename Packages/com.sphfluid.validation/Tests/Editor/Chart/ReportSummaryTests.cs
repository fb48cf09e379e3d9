using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Sentences and numbers of the report. FlatCase's floor is 0.04.</summary>
    public sealed class ReportSummaryTests
    {
        private static readonly FlatCase flat = new FlatCase("flat");

        private ChartRows table;

        [SetUp]
        public void SetUp() => table = new ChartRows("device");

        [Test]
        public void SaysWhatAnErrorCostsWithEachMethod()
        {
            Add("thesis", 2.0, 100, 0.3);
            Add("thesis", 2.5, 300, 0.12);
            Add("standard", 2.0, 120, 0.09);
            Add("standard", 2.5, 480, 0.06);

            Assert.That(Sentences(), Is.EqualTo(new[]
            {
                "An error of 10 %: standard from 120 ms of GPU time per simulated second (2 ms a frame); thesis, corrected never, 12 % " +
                "at best.",
                "The least error in 4 ms of a 60 Hz frame: standard 9 %; thesis, corrected 30 %.",
                "At equal GPU time the error of standard is 0.35 to 0.57 times that of thesis, corrected.",
                "The reference itself is good for 4 % (two made-up rests lie so far apart): methods below that are equal.",
            }));
        }

        [Test]
        public void ErrorsBelowTheFloorAreSaidToBeEqual()
        {
            Add("thesis", 2.0, 100, 0.03);
            Add("standard", 2.0, 100, 0.01);

            Assert.That(Sentences(), Has.Some.EqualTo("At equal GPU time the errors of standard and thesis, corrected are equal."));
        }

        [Test]
        public void AMethodWithoutAPointThatCompletedIsSaidToFail()
        {
            Add("thesis-printed", 2.0, 100, 0.3, "energy grew");
            Add("standard", 2.0, 800, 0.09);

            Assert.That(Sentences()[0], Does.Contain("thesis, as printed never, a run of each point failed"));
            Assert.That(Sentences()[1], Does.Contain("standard no point that cheap"));
        }

        [Test]
        public void APointThatIsRightByChanceCostsNothing()
        {
            Add("thesis", 2.0, 100, 0.05, null, 6);
            Add("thesis", 2.0, 400, 0.2);
            Add("standard", 2.0, 300, 0.045);

            Assert.That(Sentences()[0],
                Does.StartWith("An error of 5 %: standard from 300 ms").And.Contain("thesis, corrected never, 20 % at best"));
        }

        [Test]
        public void ATableWithoutTheErrorIsSaidToLackIt()
        {
            Add("standard", 2.0, 800, double.NaN);

            Assert.That(Sentences().Single(), Does.StartWith("No point has this error and a time"));
        }

        [TestCase(0.021, 0.05)]
        [TestCase(0.012, 0.05, Description = "the floor, 0.04, counts")]
        [TestCase(0.051, 0.1)]
        [TestCase(0.1, 0.1)]
        [TestCase(0.3, 0.5)]
        [TestCase(1.2, 2)]
        public void TheErrorAskedForIsTheLeastRoundOneThatAMethodReaches(double best, double level)
        {
            Add("standard", 2.0, 100, best);
            Add("thesis", 2.0, 100, 3 * best);

            Assert.That(ReportSummary.Level(Reported()), Is.EqualTo(level).Within(1e-12));
        }

        [TestCase(0.0123, "0.012")]
        [TestCase(0.5, "0.5")]
        [TestCase(9.94, "9.9")]
        [TestCase(9.96, "10")]
        [TestCase(123.4, "123")]
        [TestCase(12345, "12,345")]
        [TestCase(0.0000123, "0.000012")]
        [TestCase(0, "0")]
        [TestCase(double.NaN, "–")]
        public void NumbersHaveTwoDigits(double value, string text) => Assert.That(ReportWords.Digits(value), Is.EqualTo(text));

        [Test]
        public void RangesGoFromTheLaterMethodToTheEarlier()
        {
            Add("thesis", 2.0, 100, 0.4);
            Add("thesis", 2.5, 400, 0.1);
            Add("standard", 2.0, 100, 0.2);
            Add("standard", 2.5, 1000, 0.05);
            EqualCostRange range = EqualCostRange.Of(Reported().Comparisons).Single();

            Assert.That((range.Method.Name, range.Other.Name, range.Count, range.Bounds), Is.EqualTo(("standard", "thesis", 4, 1)));
            Assert.That((range.Shortest, range.Longest), Is.EqualTo((100.0, 1000.0)));
            Assert.That(range.Ratios, Is.EqualTo("0.5 to 0.87"));
        }

        private string[] Sentences() => ReportSummary.Of(Reported()).ToArray();

        private ReportCase Reported()
        {
            IReadOnlyList<ChartPanel> group = ChartPanel.Of(flat, table.Rows);
            return new ReportCase(group, EqualCost.Of(group[0].Points, flat.Floor), new CaseCurves(flat, "no such folder"));
        }

        private void Add(string method, double kappa, double cost, double error, string failure = null, int resolution = 12)
        {
            CaseParameters parameters = flat.Base(CaseMethod.Find(method));
            parameters.Resolution = resolution;
            parameters.SupportRatio = kappa;
            table.Add(new ChartRun(new ChartConfig(flat, parameters, ChartFactor.Support), 1), FlatCase.Result(cost, error, failure),
                "2026-11-21");
        }
    }
}
