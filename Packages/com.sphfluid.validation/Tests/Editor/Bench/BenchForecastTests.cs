using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class BenchForecastTests
    {
        private const int Particles = 4096, Samples = 5;

        // A step of the calibration's 4,096 particles takes 10 ms, a sample 0.2 s at least.
        private static BenchForecast Create() => new BenchForecast(0.01, 0.2, Samples);

        [Test]
        public void ARowIsItsSamplesOneToWarmUpAndOneOfItsPasses()
        {
            BenchForecast forecast = Create();
            forecast.AddRow(BenchConfig.Step(BenchSolver.Standard), Particles);

            // Seven samples of 0.2 s, each with a step before and what a sample costs besides.
            Assert.That(forecast.Left.TotalSeconds, Is.EqualTo(7 * (0.2 + 0.01 + 0.2)).Within(1).Percent);
        }

        [Test]
        public void ALargeRowIsAsLongAsItsFrame()
        {
            BenchForecast forecast = Create();
            forecast.AddRow(BenchConfig.StepsAtOnce(BenchSolver.Standard), 256 * Particles);

            Assert.That(forecast.Left.TotalSeconds, Is.GreaterThan(7 * 24 * 1.5), "24 steps of some 2 s");
        }

        [Test]
        public void AFallIsAHundredSteps()
        {
            BenchForecast forecast = Create();
            forecast.AddFall(BenchSolver.Standard, Particles);
            Assert.That(forecast.Left.TotalSeconds, Is.EqualTo(1.0).Within(1).Percent);
            forecast.TakeFall(BenchSolver.Standard, Particles, 2.0);
            Assert.That(forecast.Left.TotalSeconds, Is.Zero);
        }

        [Test]
        public void WhatWasMeasuredCountsForItsRowAndCorrectsTheOthers()
        {
            BenchForecast forecast = Create();
            BenchConfig measured = BenchConfig.Step(BenchSolver.Standard), other = BenchConfig.Step(BenchSolver.StandardSearch);
            forecast.AddRow(measured, Particles);
            forecast.AddRow(other, Particles);
            double before = forecast.Left.TotalSeconds;
            for (int i = 0; i < 2 + Samples; i++) forecast.TakeSample(measured, Particles, 4.1);

            // The other row was expected to take half; its like took ten times what was expected.
            Assert.That(forecast.Left.TotalSeconds / (0.5 * before), Is.InRange(5.0, 10.0));
            for (int i = 0; i < 2 + Samples; i++) forecast.TakeSample(other, Particles, 1.0);
            Assert.That(forecast.Left.TotalSeconds, Is.Zero);
        }

        [Test]
        public void ADenseGridCostsItsCells()
        {
            BenchForecast coarse = Create(), fine = Create();
            coarse.AddRow(BenchConfig.DenseSurface(32), Particles);
            fine.AddRow(BenchConfig.DenseSurface(256), Particles);

            Assert.That(fine.Left.TotalSeconds, Is.GreaterThan(10.0 * coarse.Left.TotalSeconds));
        }
    }
}
