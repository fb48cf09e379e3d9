using System;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class HydrostaticMetricTests
    {
        const int Layers = 20, Layer = 9;
        const double Depth = 1, Gravity = 9.81, Begin = 1;

        [Test]
        public void ExactPressureHasNoError([Values(false, true)] bool half)
        {
            FluidSolverSettings settings = Settings(half, 1e12);
            HydrostaticMetric metric = Watched(settings, 1, d => 1000 * Gravity * d, 0, 1000);

            Assert.That(metric.Evaluate()[0].Name, Is.EqualTo("slope of the pressure over depth"));
            Assert.That(metric.Evaluate()[0].Value, Is.LessThan(1e-5));
            Assert.That(WallCaseStates.Named(metric, "slope/(ρg), as read"), Is.EqualTo(1).Within(1e-5));
            Assert.That(WallCaseStates.Named(metric, "slope/(ρg), as it pushes"), Is.EqualTo(half ? 0.5 : 1).Within(1e-5));
            Assert.That(WallCaseStates.Named(metric, "height lost beyond the equation of state's"), Is.Zero.Within(1e-5));
            Assert.That(WallCaseStates.Named(metric, "v_rms/√(gH)"), Is.Zero);
            Assert.That(WallCaseStates.Named(metric, "mean |ρ/ρ0 − 1|"), Is.Zero);
        }

        [Test]
        public void APressureThatReadsTwiceErrsByOne()
        {
            HydrostaticMetric metric = Watched(Settings(true, 1e12), 1, d => 500 + 2 * 1000 * Gravity * d, 0, 1000);

            Assert.That(metric.Evaluate()[0].Value, Is.EqualTo(1).Within(1e-5));
            Assert.That(WallCaseStates.Named(metric, "slope/(ρg), as it pushes"), Is.EqualTo(1).Within(1e-5));
            Assert.That(metric.Series().Count, Is.EqualTo(3));
            Assert.That(metric.Series()[1].Y[19], Is.EqualTo(2 * metric.Series()[2].Y[19]).Within(1e-6));
        }

        [Test]
        public void HeightSpeedAndDensityAreTold()
        {
            // m = 25: the equation of state alone leaves 0.98052 of the height; the column has 0.95 of it.
            FluidSolverSettings settings = Settings(false, 25 * Gravity * Depth);
            HydrostaticMetric metric = Watched(settings, 0.95, d => 0, 0.02f, 1030);

            Assert.That(WallCaseStates.Named(metric, "height lost beyond the equation of state's"), Is.EqualTo(0.98052 - 0.95).Within(1e-4));
            Assert.That(WallCaseStates.Named(metric, "v_rms/√(gH)"), Is.EqualTo(0.02 / Math.Sqrt(Gravity)).Within(1e-6));
            Assert.That(WallCaseStates.Named(metric, "mean |ρ/ρ0 − 1|"), Is.EqualTo(0.03).Within(1e-6));
        }

        [TestCase(5, 0.912)]
        [TestCase(20, 0.976)]
        [TestCase(100, 0.995)]
        public void HeightRatioFollowsTheEquationOfState(double m, double ratio)
        {
            Assert.That(HydrostaticMetric.HeightRatio(m), Is.EqualTo(ratio).Within(5e-4));
        }

        [Test]
        public void FloorAndSurfaceAndTheStartDoNotCount()
        {
            FluidSolverSettings settings = Settings(false, 1e12);
            var metric = new HydrostaticMetric(settings, Depth, Layer, Begin);
            metric.Sample(0.5 * Begin, Column(1, d => 1e9, 5, 1));
            double edge = 3 * settings.Spacing;
            metric.Sample(Begin, Column(1, d => d < edge || d > Depth - edge ? 1e9 : 1000 * Gravity * d, 0, 1000));

            Assert.That(metric.Evaluate()[0].Value, Is.LessThan(1e-5));
            Assert.That(WallCaseStates.Named(metric, "v_rms/√(gH)"), Is.Zero);
        }

        [Test]
        public void AColumnThatHasFallenFlatIsAFailure()
        {
            FluidSolverSettings settings = Settings(false, 1e12);
            var metric = new HydrostaticMetric(settings, Depth, Layer, Begin);
            metric.Sample(Begin, Column(0.3, d => 0, 0, 1000));

            Assert.That(metric.Failure, Does.Contain("sunk to 6 dx"));
            Assert.That(metric.Evaluate()[0].Value, Is.NaN);
        }

        static FluidSolverSettings Settings(bool half, double soundSquared) => new FluidSolverSettings
        {
            DomainSize = new Vector3(0.15f, 1.2f, 0.15f),
            Spacing = (float)(Depth / Layers),
            RestDensity = 1000f,
            Gravity = new Vector3(0, -(float)Gravity, 0),
            PressureHalf = half,
            Stiffness = (float)(half ? 2 * soundSquared : soundSquared),
        };

        static HydrostaticMetric Watched(in FluidSolverSettings settings, double height, Func<double, double> pressure, float speed, double density)
        {
            var metric = new HydrostaticMetric(settings, Depth, Layer, Begin);
            for (int s = 0; s < 6; s++)
                metric.Sample(0.4 * s, Column(height, pressure, speed, density));
            return metric;
        }

        // Layers in equal steps from the floor at y = −0.6 to a surface at height, half a spacing above the last.
        static FluidSnapshot Column(double height, Func<double, double> pressure, float speed, double density)
        {
            double top = height - 0.5 * Depth / Layers;
            double Above(int i) => 0.5 * Depth / Layers + (top - 0.5 * Depth / Layers) * (i / Layer) / (Layers - 1);
            return WallCaseStates.State(Layers * Layer, i => new Vector3(0.05f * (i % 3), (float)(Above(i) - 0.6), 0.05f * (i / 3 % 3)),
                i => new Vector3(i % 2 == 0 ? speed : -speed, 0, 0), i => density, i => pressure(height - Above(i)));
        }
    }
}
