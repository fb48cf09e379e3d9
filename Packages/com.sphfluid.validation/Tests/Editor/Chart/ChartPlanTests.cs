using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class ChartPlanTests
    {
        private static readonly ValidationCase[] cases = { new FlatCase("one"), new FlatCase("two") };

        [Test]
        public void FullPlanSweepsOneFactorAtATime()
        {
            ChartPlan plan = ChartPlan.Full(cases, CaseMethod.All);

            List<ChartRun> runs = plan.Runs.Where(r => r.Config.Case == cases[1] && r.Config.Method.Name == "thesis").ToList();
            // 12 × 0.5, 0.67, 1.5, 2; κ besides 2; dt besides 0.5; c × 0.5 and 2.
            Assert.That(Values(runs, ChartFactor.Spacing, c => System.Math.Round(1.0 / c.Spacing)),
                Is.EquivalentTo(new[] { 6.0, 8.0, 18.0, 24.0 }));
            Assert.That(Values(runs, ChartFactor.Support, c => c.SupportRatio), Is.EquivalentTo(new[] { 1.75, 2.5, 3.0 }));
            Assert.That(Values(runs, ChartFactor.TimeStep, c => c.TimeStepFraction), Is.EquivalentTo(new[] { 0.25, 0.75 }));
            Assert.That(Values(runs, ChartFactor.SoundSpeed, c => c.SoundSpeedRatio), Is.EquivalentTo(new[] { 2.5, 10.0 }));
            Assert.That(runs.Where(r => r.Config.Factor != ChartFactor.Base).All(r => DiffersInOne(r.Config)), Is.True);
            // The text as printed is there to be compared with.
            Assert.That(plan.Runs.Where(r => r.Config.Method.Kind == FluidMethodKind.ThesisPrinted).Select(r => r.Config.Factor).Distinct(),
                Is.EquivalentTo(new[] { ChartFactor.Base, ChartFactor.Spacing }));
        }

        [Test]
        public void EachSupportAndHalfTheSpeedOfSoundHaveSpacingsOfTheirOwnInAMethodThatUsersChoose()
        {
            List<ChartConfig> own = ChartPlan.Full(cases, CaseMethod.All).Runs
                .Where(r => r.Seed == 1 && r.Config.Case == cases[0] && r.Config.Method.Name == "standard")
                .Select(r => r.Config).ToList();

            foreach (double support in new[] { 2.25, 2.5 })
            {
                Assert.That(own.Where(c => c.SupportRatio == support && c.SoundSpeedRatio == 5.0)
                    .Select(c => System.Math.Round(1.0 / c.Spacing)), Is.EquivalentTo(new[] { 6.0, 8.0, 12.0 }));
            }
            Assert.That(own.Where(c => c.SupportRatio == 2.0 && c.SoundSpeedRatio == 2.5).Select(c => System.Math.Round(1.0 / c.Spacing)),
                Is.EquivalentTo(new[] { 6.0, 8.0, 12.0 }));
            Assert.That(own.Where(c => c.Factor == ChartFactor.Several).All(c => c.TimeStepFraction == 0.5), Is.True);
        }

        [Test]
        public void FullPlanHasFiveSeedsAtBasesAndThreeElsewhere()
        {
            ChartPlan plan = ChartPlan.Full(cases, CaseMethod.All);

            foreach (IGrouping<string, ChartRun> seeds in plan.Runs.GroupBy(r => r.Config.Key))
            {
                ChartConfig config = seeds.First().Config;
                int expected = config.Factor == ChartFactor.Base && !config.Method.IsReference ? 5 : 3;
                Assert.That(seeds.Select(r => r.Seed), Is.EqualTo(Enumerable.Range(1, expected)), seeds.Key);
            }
            int points = cases.Length * CaseMethod.All.Count;
            Assert.That(plan.Runs.Take(points).All(r => r.Config.Factor == ChartFactor.Base && r.Seed == 1), Is.True);
            Assert.That(plan.Runs.All(r => r.Config.Parameters(r.Seed).Jitter == 0.01 && r.Config.Parameters(r.Seed).Seed == r.Seed),
                Is.True);
        }

        [Test]
        public void LongRunsAreLeftOutAndReported()
        {
            double limit = new ChartRun(new ChartConfig(cases[0], cases[0].Base(CaseMethod.Find("thesis")), ChartFactor.Base), 1).Cost *
                4.0;
            CaseMethod[] method = { CaseMethod.Find("thesis") };
            ChartPlan all = ChartPlan.Full(cases, method), limited = ChartPlan.Full(cases, method, runLimit: limit);

            Assert.That(limited.Runs.Count + limited.LeftOut.Count, Is.EqualTo(all.Runs.Count));
            Assert.That(limited.LeftOut.Any(r => r.Config.Factor == ChartFactor.Spacing && r.Config.Particles == 24 * 24 * 24), Is.True);
            Assert.That(limited.Runs.All(r => r.Cost <= limit), Is.True);
            Assert.That(limited.DescribeLeftOut(), Is.EqualTo("spacing dx of one, two"));
        }

        [Test]
        public void AFullPlanKeepsItsBudgetAndAnExpensiveCaseTakesNothingFromACheapOne()
        {
            ValidationCase[] mixed = { new FlatCase("costly", 20), new FlatCase("cheap", 8) };
            ChartPlan whole = ChartPlan.Full(new[] { mixed[1] }, CaseMethod.All);
            double budget = 6.0 * whole.Cost;
            ChartPlan plan = ChartPlan.Full(mixed, CaseMethod.All, budget);

            Assert.That(plan.Cost, Is.LessThanOrEqualTo(budget));
            Assert.That(plan.Runs.Count(r => r.Config.Case == mixed[1]), Is.EqualTo(whole.Runs.Count));
            Assert.That(plan.Runs.Count(r => r.Config.Case == mixed[0]), Is.GreaterThan(0));
            Assert.That(plan.LeftOut.All(r => r.Config.Case == mixed[0]), Is.True);
        }

        [Test]
        public void TheFullPlanOfAllCasesHasTheSpacingsThatFitsNeedWithinItsTimeOnTwoCores()
        {
            ValidationCase[] charted = CaseCatalogue.All.Where(c => !c.IsGate).ToArray();
            ChartPlan plan = ChartPlan.Full(charted, CaseMethod.All, ChartPlan.FullBudget(true), ChartPlan.SoftwareRunLimit);

            Assert.That(plan.Cost / StepWork.SoftwareRate, Is.LessThan(57.0 * 60.0));
            foreach (ValidationCase c in charted)
            {
                List<ChartRun> own = plan.Runs.Where(r => r.Config.Case == c && r.Config.Method.Name == "standard").ToList();
                CaseParameters start = c.Base(CaseMethod.Find("standard"));
                List<IGrouping<string, ChartRun>> spacings = own.Where(r => r.Config.SupportRatio.Equals(start.SupportRatio) &&
                    r.Config.SoundSpeedRatio.Equals(start.SoundSpeedRatio) &&
                    r.Config.TimeStepFraction.Equals(start.TimeStepFraction)).GroupBy(r => r.Config.Key).ToList();
                Assert.That(spacings, Has.Count.GreaterThanOrEqualTo(3), c.Name);
                Assert.That(spacings.Count(g => g.Count() >= 3), Is.GreaterThanOrEqualTo(2), c.Name);
            }
        }

        [Test]
        public void ImpossiblePointsAreReported()
        {
            var small = new FlatCase("small") { SupportLimit = 2.5 };
            ChartPlan plan = ChartPlan.Full(new[] { small }, new[] { CaseMethod.Find("thesis") });

            Assert.That(plan.Unbuildable.Select(c => c.SupportRatio), Is.EqualTo(new[] { 2.5, 3.0 }));
            Assert.That(plan.Unbuildable[0].Problem, Does.Contain("too small"));
            Assert.That(plan.Runs.All(r => r.Config.SupportRatio < 2.5), Is.True);
        }

        [Test]
        public void QuickPlanSweepsAllButReferencesAndHasThreeSeedsOfTheirSpacings()
        {
            ChartPlan plan = ChartPlan.Quick(cases, CaseMethod.All, double.PositiveInfinity);

            Assert.That(plan.LeftOut, Is.Empty);
            foreach (IGrouping<string, ChartRun> runs in plan.Runs.GroupBy(r => r.Config.Case.Name + r.Config.Method.Name))
            {
                bool isReference = runs.First().Config.Method.IsReference;
                List<ChartRun> sweep = runs.Where(r => r.Config.Factor != ChartFactor.Base).ToList();
                Assert.That(runs.Count() - sweep.Count, Is.EqualTo(isReference ? 1 : 3), runs.Key);
                Assert.That(sweep.Where(r => r.Config.Factor == ChartFactor.Spacing).GroupBy(r => r.Config.Key).Select(g => g.Count()),
                    Is.EqualTo(isReference ? new[] { 1, 1 } : new[] { 3, 3 }));
                if (!isReference)
                {
                    Assert.That(sweep.Select(r => r.Config.Factor).Distinct(),
                        Is.EquivalentTo(new[] { ChartFactor.Spacing, ChartFactor.Support, ChartFactor.TimeStep, ChartFactor.SoundSpeed }));
                }
                // κ = 2 is the made-up case's base.
                if (runs.First().Config.Method.Kind == FluidMethodKind.Standard && !isReference)
                {
                    Assert.That(Values(sweep, ChartFactor.Support, c => c.SupportRatio), Is.EqualTo(new[] { 2.25, 2.5 }));
                }
            }
        }

        [Test]
        public void QuickPlanKeepsItsBudget()
        {
            ValidationCase[] mixed = { new FlatCase("cheap", 8), new FlatCase("costly", 40) };
            double cheap = new ChartRun(new ChartConfig(mixed[0], mixed[0].Base(CaseMethod.All[0]), ChartFactor.Base), 1).Cost;
            double budget = 90.0 * cheap;
            ChartPlan plan = ChartPlan.Quick(mixed, CaseMethod.All, budget);

            Assert.That(plan.Cost, Is.LessThanOrEqualTo(budget));
            Assert.That(plan.LeftOut, Is.Not.Empty);
            Assert.That(plan.DescribeLeftOut(), Does.Contain("base of costly").And.Not.Contain("cheap"));
            // The costly one has coarser points: each panel has one at least.
            foreach (ValidationCase c in mixed) Assert.That(plan.Runs.Count(r => r.Config.Case == c), Is.GreaterThan(0), c.Name);
        }

        [Test]
        public void QuickPlanOfAllCasesTakesLessThanTenMinutesOnTwoCores()
        {
            ValidationCase[] charted = CaseCatalogue.All.Where(c => !c.IsGate).ToArray();
            ChartPlan plan = ChartPlan.Quick(charted, CaseMethod.All);

            Assert.That(plan.Cost / StepWork.SoftwareRate, Is.LessThan(480.0));
            foreach (ValidationCase c in charted)
            {
                foreach (CaseMethod method in CaseMethod.All)
                {
                    bool isRun = plan.Runs.Any(r => r.Config.Case == c && r.Config.Method == method);
                    bool cannot = plan.Unbuildable.Any(u => u.Case == c && u.Method == method && u.Factor == ChartFactor.Base);
                    Assert.That(isRun != cannot, $"{c.Name}, {method.Name}");
                    Assert.That(cannot, Is.EqualTo(c is HeaveCase && method.Name.StartsWith("thesis") ||
                        c is WallImpactCase && !method.FeelsWalls || c is CapillaryDropCase && !method.HasTension),
                        "only what a method lacks keeps it from a case");
                }
                Assert.That(plan.Runs.Where(r => r.Config.Case == c && r.Config.Method.Kind == FluidMethodKind.Standard)
                    .Select(r => r.Config.SupportRatio).Distinct(),
                    Is.SupersetOf(new[] { 2.0, 2.25, 2.5 }),
                    c.Name + ": " + string.Join("; ", plan.Unbuildable.Concat(plan.LeftOut.Select(r => r.Config)).Where(u => u.Case == c)));
            }
        }

        [Test]
        public void MoreNeighboursCostMore()
        {
            CaseParameters wide = cases[0].Base(CaseMethod.All[0]);
            var narrow = new ChartRun(new ChartConfig(cases[0], wide, ChartFactor.Base), 1);
            wide.SupportRatio = 3.0;

            Assert.That(new ChartRun(new ChartConfig(cases[0], wide, ChartFactor.Support), 1).Cost, Is.GreaterThan(1.5 * narrow.Cost));
        }

        private static IEnumerable<double> Values(IEnumerable<ChartRun> runs, ChartFactor factor, System.Func<ChartConfig, double> value) =>
            runs.Where(r => r.Config.Factor == factor && r.Seed == 1).Select(r => value(r.Config));

        private static bool DiffersInOne(ChartConfig config)
        {
            CaseParameters start = config.Case.Base(config.Method), point = config.Parameters(1);
            int differences = (start.Resolution != point.Resolution ? 1 : 0) + (start.SupportRatio != point.SupportRatio ? 1 : 0) +
                (start.TimeStepFraction != point.TimeStepFraction ? 1 : 0) + (start.SoundSpeedRatio != point.SoundSpeedRatio ? 1 : 0);
            return differences == 1;
        }
    }
}
