using System;
using System.Collections.Generic;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class DampedOscillationFitTests
    {
        [TestCase(1.0, 0.05, 0.0)]
        [TestCase(0.6, 0.0, 0.3)]
        [TestCase(2.1, 0.4, -2.0)]
        [TestCase(1.3, -0.1, 5.0)]
        public void ConstantsAreFoundAgain(double frequency, double rate, double offset)
        {
            DampedOscillationFit fit = Fit(t => offset + 0.7 * Math.Exp(-rate * t) * Math.Cos(frequency * t + 0.4), 1.0);

            Assert.That(fit.Frequency, Is.EqualTo(frequency).Within(1e-6));
            Assert.That(fit.Period, Is.EqualTo(2 * Math.PI / frequency).Within(1e-5));
            Assert.That(fit.DampingRate, Is.EqualTo(rate).Within(1e-6));
            Assert.That(fit.Amplitude, Is.EqualTo(0.7).Within(1e-6));
            Assert.That(fit.Residual, Is.LessThan(1e-6));
        }

        [Test]
        public void NoiseIsLeftAndDoesNotMoveTheFitFar()
        {
            var random = new Random(3);
            DampedOscillationFit fit = Fit(t => Math.Cos(t) + 0.2 * (random.NextDouble() - 0.5), 1.0);

            Assert.That(fit.Frequency, Is.EqualTo(1).Within(0.01));
            Assert.That(fit.Residual, Is.EqualTo(0.2 / Math.Sqrt(12) / Math.Sqrt(0.5)).Within(0.02));
        }

        [Test]
        public void WhatDoesNotSwingHasNoFit()
        {
            Assert.That(Fit(t => 3.0, 1.0), Is.Null);
            Assert.That(Fit(t => double.NaN, 1.0), Is.Null);
            var random = new Random(5);
            Assert.That(Fit(t => random.NextDouble(), 1.0), Is.Null, "noise");
        }

        [Test]
        public void LinesGoThroughTheirPoints()
        {
            var line = new LineFit();
            Assert.That(line.Slope, Is.NaN);
            for (int i = 0; i < 7; i++) line.Add(1e6 + i, 4 - 0.25 * i + (i % 2 == 0 ? 0 : 0.01));

            // By hand: points (0, 0) (1, 0.01) (2, 0) … about their mean have no slope, the odd ones being symmetric.
            Assert.That(line.Slope, Is.EqualTo(-0.25).Within(1e-9));
            Assert.That(line.Intercept + line.Slope * 1e6, Is.EqualTo(4 + 0.03 / 7).Within(1e-3));
            Assert.That(line.Count, Is.EqualTo(7));
        }

        private static DampedOscillationFit Fit(Func<double, double> signal, double expected)
        {
            var times = new List<double>();
            var values = new List<double>();
            for (double t = 0; t < 13; t += 0.17)
            {
                times.Add(t);
                values.Add(signal(t));
            }
            return DampedOscillationFit.Of(times, values, expected, "a-case", "the sample");
        }
    }
}
