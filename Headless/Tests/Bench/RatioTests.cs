using Headless.Bench.Scene;
using NUnit.Framework;

namespace Headless.Tests.Bench;

public sealed class RatioTests
{
    [Test]
    public void SumsAndSinglePairsAreHeldApart()
    {
        Ratio ratio = Ratio.Of([(1, 2), (1, 3), (2, 2), (4, 20), (2, 8)]);

        Assert.That(ratio.OfSums, Is.EqualTo(35.0 / 10.0));
        Assert.That((ratio.Low, ratio.Median, ratio.High), Is.EqualTo((2.0, 3.0, 4.0)));
    }

    [Test]
    public void WhatSleepsHasNoRatioOfPairs()
    {
        Ratio ratio = Ratio.Of([(0, 2), (0, 3)]);

        Assert.That(ratio.OfSums, Is.EqualTo(double.PositiveInfinity));
        Assert.That(ratio.Median, Is.NaN);
    }

    [TestCase(0.0, 1.0)]
    [TestCase(0.5, 2.5)]
    [TestCase(1.0, 4.0)]
    public void QuantilesLieBetweenNumbers(double share, double expected) =>
        Assert.That(Ratio.At([1, 2, 3, 4], share), Is.EqualTo(expected));
}
