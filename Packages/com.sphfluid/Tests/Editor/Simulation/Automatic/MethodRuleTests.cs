using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// The rule by made-up costs: the first that fits, else the first about as cheap as the cheapest; of those that fit a larger budget
    /// never picks one further down.
    /// </summary>
    public sealed class MethodRuleTests
    {
        // As the profile asks 10 ms, softer 6 ms, fixed steps 4 ms.
        private static readonly double[] Usual = { 10.0, 6.0, 4.0 };

        [TestCase(10.0, 0)]
        [TestCase(100.0, 0)]
        [TestCase(9.99, 1)]
        [TestCase(6.0, 1)]
        [TestCase(5.99, 2)]
        [TestCase(4.0, 2)]
        [TestCase(3.99, 2)]
        [TestCase(0.01, 2)]
        public void TheFirstThatFitsElseTheCheapest(double budget, int expected) =>
            Assert.That(MethodRule.Pick(Of(Usual), budget), Is.EqualTo(expected));

        [Test]
        public void TheCheapestNeedNotBeTheLast() => Assert.That(MethodRule.Pick(Of(10.0, 3.0, 5.0), 1.0), Is.EqualTo(1));

        [Test]
        public void OfEquallyCheapOnesTheMoreFaithful() => Assert.That(MethodRule.Pick(Of(5.0, 5.0, 5.0), 1.0), Is.Zero);

        // Costs are good for some 25 per cent, which decides nothing where none fits.
        [TestCase(1.0, 1)]
        [TestCase(3.9, 1)]
        [TestCase(4.0, 2)]
        [TestCase(4.9, 2)]
        [TestCase(5.0, 1)]
        public void OfAboutEquallyCheapOnesTheMoreFaithfulUnlessOnlyAnotherFits(double budget, int expected) =>
            Assert.That(MethodRule.Pick(Of(5.1, 5.0, 4.0), budget), Is.EqualTo(expected));

        [Test]
        public void WhatIsNotKnownIsNotPickedBeforeWhatIs()
        {
            Assert.That(MethodRule.Pick(Of(double.NaN, double.NaN, 4.0), 1.0), Is.EqualTo(2));
            Assert.That(MethodRule.Pick(Of(double.NaN, 4.0), 5.0), Is.EqualTo(1));
            Assert.That(MethodRule.Pick(Of(double.NaN, double.NaN), 5.0), Is.Zero, "nothing is known");
        }

        [Test]
        public void WhatCannotBeIsNotPicked()
        {
            List<FluidMethodCandidate> candidates = Of(1.0, 2.0, 3.0);
            candidates[0] = Obstructed();
            Assert.That(MethodRule.Pick(candidates, 10.0), Is.EqualTo(1));
            for (int i = 0; i < candidates.Count; i++) candidates[i] = Obstructed();
            Assert.That(MethodRule.Pick(candidates, 10.0), Is.EqualTo(-1));
            Assert.That(MethodRule.Pick(new FluidMethodCandidate[0], 10.0), Is.EqualTo(-1));
        }

        [Test]
        public void ALargerBudgetNeverPicksOneFurtherDown()
        {
            var random = new System.Random(5);
            for (int trial = 0; trial < 2000; trial++)
            {
                var costs = new double[1 + random.Next(5)];
                for (int i = 0; i < costs.Length; i++) costs[i] = random.Next(8) == 0 ? double.NaN : 0.5 + 20.0 * random.NextDouble();
                List<FluidMethodCandidate> candidates = Of(costs);
                int before = int.MaxValue;
                bool known = false;
                for (double budget = 0.25; budget < 40.0; budget *= 1.07)
                {
                    int pick = MethodRule.Pick(candidates, budget);
                    Assert.That(pick, Is.InRange(0, costs.Length - 1));
                    bool fits = costs[pick] <= budget;
                    if (fits) Assert.That(pick <= before || !known, $"trial {trial}, budget {budget}");
                    (before, known) = (pick, fits);
                }
            }
        }

        [Test]
        public void CostsThatWaverDoNotChangeThePickToAndFro()
        {
            int pick = MethodRule.Pick(Of(3.9, 2.0), 4.0), changes = 0;
            for (int i = 0; i < 100; i++)
            {
                int next = MethodRule.Pick(Of(4.0 + 0.25 * Mathf.Sin(i), 2.0), 4.0, pick);
                if (next != pick) changes++;
                pick = next;
            }
            Assert.That(changes, Is.LessThanOrEqualTo(1), "once down, and not up again by a few percent");
            Assert.That(pick, Is.EqualTo(1));
            Assert.That(MethodRule.Pick(Of(3.5, 2.0), 4.0, 1), Is.Zero, "well below the budget");
        }

        [Test]
        public void APresentPickThatDoesNotFitIsNoReasonToStay() => Assert.That(MethodRule.Pick(Of(10.0, 3.9, 5.0), 4.0, 2), Is.EqualTo(1));

        private static List<FluidMethodCandidate> Of(params double[] costs)
        {
            var candidates = new List<FluidMethodCandidate>();
            foreach (double cost in costs)
            {
                candidates
                    .Add(new FluidMethodCandidate(new MethodOffer { StepsAFrame = 1.0, CostRatio = 1.0 }, cost,
                        FluidCostSource.MeasuredInPlay, null));
            }
            return candidates;
        }

        private static FluidMethodCandidate Obstructed() =>
            new FluidMethodCandidate(new MethodOffer { StepsAFrame = 1.0, CostRatio = 1.0 }, 1.0, FluidCostSource.MeasuredInPlay,
                "does not run on this device");
    }
}
