using System;
using System.Collections.Generic;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class StandingWaveMetricTests
    {
        private const double Depth = 1, Length = 2, WaveNumber = Math.PI, Frequency = 1.769, Viscosity = 0.004, Amplitude = 0.05,
            Begin = 0.7, Floor = -0.6;

        [TestCase(1.0, 1.0)]
        [TestCase(1.1, 1.0)]
        [TestCase(0.75, 4.0)]
        [TestCase(1.02, 0.25)]
        public void PeriodAndDampingAreFound(double frequencyRatio, double viscosityRatio)
        {
            StandingWaveMetric metric = Watched(frequencyRatio * Frequency, viscosityRatio * Viscosity);

            Assert.That(metric.Evaluate()[0].Name, Is.EqualTo("period"));
            Assert.That(metric.Evaluate()[0].Value, Is.EqualTo(Math.Abs(1 / frequencyRatio - 1)).Within(1e-3));
            Assert.That(WallCaseStates.Named(metric, "numerical viscosity/ν"),
                Is.EqualTo(viscosityRatio - 1).Within(0.01 * viscosityRatio));
            Assert.That(WallCaseStates.Named(metric, "numerical viscosity [m²/s]"),
                Is.EqualTo((viscosityRatio - 1) * Viscosity).Within(4e-5 * viscosityRatio));
            Assert.That(WallCaseStates.Named(metric, "left by the fit"), Is.LessThan(0.02));
        }

        [Test]
        public void TheExactWaveIsOnTheReference()
        {
            IReadOnlyList<CaseSeries> series = Watched(Frequency, Viscosity).Series();

            Assert.That(series[0].IsReference);
            for (int i = 0; i < series[0].X.Count; i++) Assert.That(series[1].Y[i], Is.EqualTo(series[0].Y[i]).Within(1e-3));
        }

        [Test]
        public void TheBeginningIsNotFitted()
        {
            var metric = new StandingWaveMetric(Floor, Depth, WaveNumber, Frequency, Viscosity, Amplitude, Begin);
            for (int s = 0; s <= 72; s++) metric.Sample(0.1 * s, Wave(s < 7 ? 0.3 : Amplitude * Math.Cos(1.05 * Frequency * 0.1 * s)));

            Assert.That(metric.Evaluate()[0].Value, Is.EqualTo(1 - 1 / 1.05).Within(1e-3));
        }

        [Test]
        public void LiquidThatHasSunkIsAFailure()
        {
            var metric = new StandingWaveMetric(Floor, Depth, WaveNumber, Frequency, Viscosity, Amplitude, Begin);
            metric.Sample(0, Wave(Amplitude));
            Assert.That(metric.Failure, Is.Null);
            metric.Sample(0.1, Wave(Amplitude, 0.25));
            Assert.That(metric.Failure, Does.Contain("sunk to 50 %"));
        }

        [Test]
        public void WhatDoesNotSwingHasNoPeriod()
        {
            var metric = new StandingWaveMetric(Floor, Depth, WaveNumber, Frequency, Viscosity, Amplitude, Begin);
            for (int s = 0; s < 40; s++) metric.Sample(0.1 * s, Wave(0));

            Assert.That(metric.Evaluate()[0].Value, Is.NaN);
        }

        [TestCase(2.6, 1.0)]
        [TestCase(1.0, 30.0)]
        public void ASwingFarFromTheExpectedOneFails(double frequencyRatio, double viscosityRatio) =>
            Assert.That(() => Watched(frequencyRatio * Frequency, viscosityRatio * Viscosity).Evaluate(),
                Throws.TypeOf<SearchBoundException>().With.Message.StartsWith(new StandingWaveCase().Name + ": the "));

        private static StandingWaveMetric Watched(double frequency, double viscosity)
        {
            var metric = new StandingWaveMetric(Floor, Depth, WaveNumber, Frequency, Viscosity, Amplitude, Begin);
            for (int s = 0; s <= 72; s++)
            {
                double t = 0.1 * s;
                metric.Sample(t, Wave(Amplitude * Math.Exp(-2 * viscosity * WaveNumber * WaveNumber * t) * Math.Cos(frequency * t)));
            }
            return metric;
        }

        // Particles of equal volume below y = a cos kx: their x are equally spaced in the volume H x + (a/k) sin kx.
        private static FluidSnapshot Wave(double a, double height = 0.5)
        {
            const int Columns = 500;
            return WallCaseStates.State(Columns, i =>
            {
                double volume = (i + 0.5) / Columns * Length * Depth - 0.5 * Length * Depth;
                double x = volume / Depth;
                for (int k = 0; k < 60; k++) x = (volume - a / WaveNumber * Math.Sin(WaveNumber * x)) / Depth;
                return new Vector3((float)x, (float)(Floor + height * Depth + 0.3 * Math.Sin(i)), 0);
            });
        }
    }
}
