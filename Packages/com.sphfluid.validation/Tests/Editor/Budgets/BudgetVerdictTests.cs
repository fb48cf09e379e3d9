using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Picks against given ways, from made-up runs: errors in spacings, and what counts as better at the same cost.</summary>
    public sealed class BudgetVerdictTests
    {
        private static readonly BudgetWay Automatic = BudgetWay.Chosen(4.0);

        [Test]
        public void TheErrorIsTheDistanceFromTheMeanOfTheReference()
        {
            // The reference's runs are 0 and 2 cm off to the right: their mean is 1 cm; a run at 4 cm is 3 cm off, 1.5 dx.
            var rows = new List<BudgetRow> { Row(BudgetWay.Reference, 0f), Row(BudgetWay.Reference, 0.02f), Row(Automatic, 0.04f) };
            BudgetVerdict.Judge(rows);
            Assert.That(rows[2].Error, Is.EqualTo(1.5).Within(1e-5));
            Assert.That(rows[0].Error, Is.EqualTo(0.5).Within(1e-5));
        }

        [TestCase(0.05f, 1.0, "standard", TestName = "ABetterWayThatTookNoLongerIsNamed")]
        [TestCase(0.05f, 1.09, "standard", TestName = "TheSameCostIsWithinATenth")]
        [TestCase(0.05f, 1.2, "", TestName = "ADearerWayIsNone")]
        [TestCase(0.005f, 1.0, "", TestName = "AWorseWayIsNone")]
        public void WhatIsBetter(float chosen, double givenCost, string expected)
        {
            var rows = new List<BudgetRow>
            {
                Row(BudgetWay.Reference, 0f), Row(BudgetWay.Reference, 0f),
                Row(BudgetWay.Given[0], 0.010f, givenCost), Row(BudgetWay.Given[0], 0.011f, givenCost),
                Row(Automatic, chosen, 1.0, "robust"), Row(Automatic, chosen + 0.001f, 1.0, "robust"),
            };
            BudgetVerdict.Judge(rows);
            Assert.That(rows.Where(r => r.Way == Automatic).Select(r => r.BetterWay), Is.All.EqualTo(expected));
            Assert.That(rows.Where(r => r.Way != Automatic).Select(r => r.BetterWay), Is.All.Empty);
        }

        [Test]
        public void RunsOfEqualLiquidsShareTheirCost()
        {
            // A pick of the first given way, timed in a bad moment, is not cheaper or dearer than that way; another way that took half is.
            var rows = new List<BudgetRow>
            {
                Row(BudgetWay.Reference, 0f), Row(BudgetWay.Given[0], 0.05f, 1.0), Row(BudgetWay.Given[0], 0.051f, 1.0),
                Row(BudgetWay.Given[2], 0.01f, 2.0, "robust"), Row(BudgetWay.Given[2], 0.011f, 2.0, "robust"), Row(Automatic, 0.05f, 5.0),
                Row(Automatic, 0.051f, 0.2),
            };
            BudgetVerdict.Judge(rows);
            Assert.That(rows.Where(r => r.Method == "standard").Select(r => r.Cost), Is.All.EqualTo(1.0));
            Assert.That(rows.Select(r => r.BetterWay), Is.All.Empty, "what takes twice as long is not at the same cost");
        }

        [Test]
        public void AWayIsNotBetterThanItself()
        {
            var rows = new List<BudgetRow>
            {
                Row(BudgetWay.Reference, 0f), Row(BudgetWay.Given[0], 0.0500f), Row(BudgetWay.Given[0], 0.0500f), Row(Automatic, 0.0502f),
                Row(Automatic, 0.0502f),
            };
            BudgetVerdict.Judge(rows);
            Assert.That(rows.Select(r => r.BetterWay), Is.All.Empty, "Automatic picked that way: two hundredths of a spacing are nothing");
        }

        [Test]
        public void RunsThatScatterMoreThanTheyDifferAreNoVerdict()
        {
            var rows = new List<BudgetRow>
            {
                Row(BudgetWay.Reference, 0f),
                Row(BudgetWay.Given[0], 0.005f), Row(BudgetWay.Given[0], 0.045f),
                Row(Automatic, 0.01f), Row(Automatic, 0.05f),
            };
            BudgetVerdict.Judge(rows);
            Assert.That(rows.Select(r => r.BetterWay), Is.All.Empty);
        }

        [Test]
        public void WithoutAReferenceThereAreNoErrors()
        {
            var rows = new List<BudgetRow> { Row(Automatic, 0f) };
            BudgetVerdict.Judge(rows);
            Assert.That(rows[0].Error, Is.NaN);
        }

        [Test]
        public void TheGivenWaysAreThoseThatAutomaticHas()
        {
            Assert.That(BudgetWay.Given[0].MaxCompression, Is.EqualTo(Automatic.MaxCompression));
            Assert.That(BudgetWay.Given[1].MaxCompression, Is.EqualTo(3f * Automatic.MaxCompression).Within(1e-7f));
            Assert.That(BudgetWay.Given[1].SoundSpeedRatio, Is.EqualTo(Automatic.SoundSpeedRatio / Mathf.Sqrt(3f)).Within(1e-3f));
            Assert.That(BudgetWay.Given.Select(w => w.Name).Distinct().Count(), Is.EqualTo(BudgetWay.Given.Count));
        }

        private static BudgetRow Row(BudgetWay way, float offset, double milliseconds = 1.0, string method = "standard") => new BudgetRow
        {
            Way = way,
            Method = method,
            MaxCompression = way.MaxCompression,
            Spacing = 0.02,
            Milliseconds = milliseconds,
            Path = new[] { new Vector3(offset, 0f, 0f), new Vector3(offset, 0f, 0f) },
        };
    }
}
