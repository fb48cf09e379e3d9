using Headless.Measure;
using NUnit.Framework;

namespace Headless.Tests.Measure;

/// <summary>Shares of the time: by arithmetic, without a clock.</summary>
public sealed class BudgetTests
{
    [Test]
    public void PartsThatTakeTheirWholeSharesAndAGraceEndWithinTheWhole()
    {
        double[] weights = [5, 4, 6, 22, 8, 8, 6, 12, 8, 5, 28];
        const double whole = 600, grace = 8;
        double passed = 0;
        for (int i = 0; i < weights.Length; i++) passed += Budget.Of(whole - passed, weights.Skip(i), least: 8) + grace;

        Assert.That(passed, Is.LessThanOrEqualTo(whole));
    }

    [Test]
    public void WhatAPartDoesNotTakeGoesToTheOthers()
    {
        double shared = Budget.Of(110, [1, 1], least: 8);

        Assert.That(shared, Is.EqualTo(50));
        Assert.That(Budget.Of(110 - 10, [1], least: 8), Is.EqualTo(90));
    }

    [Test]
    public void ASmallShareIsRaisedToWhatThePartNeeds()
    {
        Assert.That(Budget.Of(110, [1, 99], least: 8), Is.EqualTo(8));
        Assert.That(Budget.Of(14, [1, 99], least: 8), Is.EqualTo(4), "no more than there is");
    }

    [Test]
    public void WhereNothingIsLeftAPartGetsNothing() => Assert.That(Budget.Of(2, [1, 1], least: 8), Is.Zero);
}
