using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Every run goes to one shard, whole groups together, and shards take about as long as each other.</summary>
    public sealed class ShardDealTests
    {
        [Test]
        public void EveryRunHasOneShard([Values(1, 2, 3, 7, 100)] int shards, [Values(0, 1, 6, 7, 8, 53)] int runs)
        {
            int[] deal = ShardDeal.Of(Work(runs), shards);

            Assert.That(deal, Has.Length.EqualTo(runs));
            Assert.That(deal, Is.All.InRange(1, shards));
            // None is idle while another has two.
            Assert.That(deal.Distinct().Count(), Is.EqualTo(Math.Min(shards, runs)));
        }

        [Test]
        public void NoShardHasMoreThanTheLeastByMoreThanARun([Values(2, 3, 7)] int shards)
        {
            List<(string Group, double Cost)> work = Work(53);
            int[] deal = ShardDeal.Of(work, shards);
            double[] loads = Enumerable.Range(1, shards).Select(s => work.Where((w, i) => deal[i] == s).Sum(w => w.Cost)).ToArray();

            Assert.That(loads.Max() - loads.Min(), Is.LessThanOrEqualTo(work.Max(w => w.Cost)));
            Assert.That(loads.Max(), Is.LessThan(1.1 * loads.Average()), "and with many runs it is near the best");
        }

        [Test]
        public void TheLongestGoFirst() =>
            Assert.That(ShardDeal.Of(new[] { 3.0, 5.0, 3.0, 4.0 }.Select((cost, i) => (i.ToString(), cost)).ToList(), 2),
                Is.EqualTo(new[] { 2, 1, 1, 2 }));

        [Test]
        public void AGroupStaysTogether()
        {
            List<(string Group, double Cost)> work = Work(53).Select((w, i) => ((i % 5).ToString(), w.Cost)).ToList();
            int[] deal = ShardDeal.Of(work, 3);

            foreach (IGrouping<string, int> group in Enumerable.Range(0, 53).GroupBy(i => work[i].Group, i => deal[i]))
            {
                Assert.That(group.Distinct().Count(), Is.EqualTo(1));
            }
        }

        [Test]
        public void WorkWithoutCostIsDealtByNumber()
        {
            int[] deal = ShardDeal.Of(Work(12).Select(w => (w.Group, 0.0)).ToList(), 3);

            Assert.That(deal.GroupBy(s => s).Select(g => g.Count()), Is.EqualTo(new[] { 4, 4, 4 }));
        }

        [Test]
        public void ThePlanAloneDecides()
        {
            SweepPlan plan = SweepPlan.Of(Jobs(1.0), 3), again = SweepPlan.Of(Jobs(1.0), 3);
            // The last bits of a cost are another machine's.
            SweepPlan near = SweepPlan.Of(Jobs(1.0 + 1e-12), 3), other = SweepPlan.Of(Jobs(1.01), 3);

            Assert.That(again.Runs.Select(r => (r.Key, r.Cost, r.Shard)), Is.EqualTo(plan.Runs.Select(r => (r.Key, r.Cost, r.Shard))));
            Assert.That((again.Hash, near.Hash), Is.EqualTo((plan.Hash, plan.Hash)));
            Assert.That(near.Runs.Select(r => r.Shard), Is.EqualTo(plan.Runs.Select(r => r.Shard)));
            Assert.That(other.Hash, Is.Not.EqualTo(plan.Hash));
            Assert.That(SweepPlan.Of(Jobs(1.0), 2).Hash, Is.EqualTo(plan.Hash), "the number of shards is not the plan's");
            Assert.That(SweepPlan.Of(Jobs(1.0).Reverse().ToList(), 3).Hash, Is.Not.EqualTo(plan.Hash), "the order is");
            Assert.That(plan.Hash, Does.Match("^[0-9a-f]{16}$"));
        }

        private static IReadOnlyList<SessionJob> Jobs(double scale) =>
            Work(20)
                .Select(w => new SessionJob("run", scale * w.Cost, () => false, () => Enumerable.Empty<int>().GetEnumerator(),
                    key: "table.csv|" + w.Group)).ToList();

        // Costs over three decades, in no order.
        private static List<(string Group, double Cost)> Work(int count) =>
            Enumerable.Range(0, count).Select(i => ($"run {i}", Math.Pow(10.0, i * 7 % 53 / 17.0))).ToList();
    }
}
