using System;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class HydrostaticMetricTests
    {
        private const int Layers = 20, Layer = 9;
        private const double Depth = 1, Gravity = 9.81, Begin = 1;

        [Test]
        public void ExactPressureHasNoError([Values(false, true)] bool half)
        {
            FluidSolverSettings settings = Settings(half, 1e12);
            HydrostaticMetric metric = Watched(settings, 1, d => 1000 * Gravity * d, 0, 1000);

            Assert.That(metric.Evaluate()[0].Name, Is.EqualTo("slope of the pressure that pushes"));
            Assert.That(metric.Evaluate()[0].Value, Is.EqualTo(half ? 0.5 : 0).Within(1e-5),
                "with the half, half of the weight has no support");
            Assert.That(WallCaseStates.Named(metric, "slope/(ρg), as read"), Is.EqualTo(1).Within(1e-5));
            Assert.That(WallCaseStates.Named(metric, "slope/(ρg), as it pushes"), Is.EqualTo(half ? 0.5 : 1).Within(1e-5));
            Assert.That(WallCaseStates.Named(metric, HydrostaticMetric.FaceName), Is.EqualTo(half ? 0.5 : 1).Within(0.05),
                "read most of a spacing above the floor");
            Assert.That(metric.Evaluate().Count, Is.EqualTo(7), "no edges between periodic sides");
            Assert.That(WallCaseStates.Named(metric, "height lost beyond the equation of state's"), Is.Zero.Within(1e-5));
            Assert.That(WallCaseStates.Named(metric, "v_rms/√(gH)"), Is.Zero);
            Assert.That(WallCaseStates.Named(metric, "mean |ρ/ρ0 − 1|"), Is.Zero);
        }

        [Test]
        public void APressureThatReadsTwiceAndPushesRightHasNoError()
        {
            HydrostaticMetric metric = Watched(Settings(true, 1e12), 1, d => 500 + 2 * 1000 * Gravity * d, 0, 1000);

            Assert.That(metric.Evaluate()[0].Value, Is.LessThan(1e-5));
            Assert.That(WallCaseStates.Named(metric, "slope/(ρg), as read"), Is.EqualTo(2).Within(1e-5));
            Assert.That(WallCaseStates.Named(metric, "slope/(ρg), as it pushes"), Is.EqualTo(1).Within(1e-5));
            Assert.That(metric.Series().Count, Is.EqualTo(3));
            Assert.That(metric.Series()[1].Y[19], Is.EqualTo(2 * metric.Series()[2].Y[19]).Within(1e-6));
        }

        [Test]
        public void HeightSpeedAndDensityAreReported()
        {
            // m = 25: the equation of state alone leaves 0.98052 of the height; the column has 0.95 of it, and its layers, 0.947 dx apart,
            // reach a thirtieth of a spacing farther.
            FluidSolverSettings settings = Settings(false, 25 * Gravity * Depth);
            HydrostaticMetric metric = Watched(settings, 0.95, d => 0, 0.02f, 1030);

            Assert.That(WallCaseStates.Named(metric, "height lost beyond the equation of state's"),
                Is.EqualTo(0.98052 - 0.95).Within(0.05 / 30));
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
        public void DensityThatGrowsWithDepthIsNoError()
        {
            // m = 5: p = ρ0 c² (e^(g d/c²) − 1) is ρ0 g d times 1.107 at the floor.
            const double Square = 5 * Gravity * Depth;
            FluidSolverSettings settings = Settings(false, Square);
            double Exact(double d) => 1000 * Square * (Math.Exp(Gravity * d / Square) - 1);
            HydrostaticMetric metric = Watched(settings, 1, Exact, 0, 1000);

            Assert.That(metric.Evaluate()[0].Value, Is.LessThan(1e-5));
            Assert.That(metric.Series()[0].Y[Layers], Is.EqualTo(1.107).Within(5e-4));
        }

        [Test]
        public void SideWallsAreKeptApart()
        {
            // Half as much again within three spacings of a wall.
            FluidSolverSettings settings = Settings(false, 1e12);
            settings.DomainSize = new Vector3(0.6f, 1.2f, 0.6f);
            settings.Boundaries.Periodic = FluidAxes.None;
            var metric = new HydrostaticMetric(settings, Depth, 144, Begin);
            Vector3 Place(int i) => new Vector3(0.05f * (i % 12) - 0.275f, 0.05f * (i / 144) - 0.575f, 0.05f * (i / 12 % 12) - 0.275f);
            bool Inside(Vector3 p) => Math.Abs(p.x) < 0.15f && Math.Abs(p.z) < 0.15f;
            metric.Sample(Begin, WallCaseStates.State(Layers * 144, Place, i => Vector3.zero, i => Inside(Place(i)) ? 1000 : 2000,
                i => (Inside(Place(i)) ? 1000 : 1500) * Gravity * (0.4 - Place(i).y)));

            Assert.That(metric.Evaluate()[0].Value, Is.LessThan(1e-5));
            Assert.That(WallCaseStates.Named(metric, "mean |ρ/ρ0 − 1|"), Is.Zero);
            Assert.That(WallCaseStates.Named(metric, HydrostaticMetric.FaceName), Is.EqualTo(1.05).Within(0.1), "R reaches into the strip");
            Assert.That(WallCaseStates.Named(metric, HydrostaticMetric.EdgesName), Is.EqualTo(1.4).Within(0.1));
        }

        [TestCase(1f)]
        [TestCase(1.4f)]
        public void TheSurfaceIsWhereTheVolumeEnds(float crowding)
        {
            // Layers with more particles lie farther apart; one particle flies.
            int layer = 100, crowded = (int)(crowding * layer);
            var heights = new double[10 * crowded + 1];
            for (int i = 0; i < 10 * crowded; i++) heights[i] = (i / crowded + 0.5) * crowding;
            heights[10 * crowded] = 30;

            Assert.That(LiquidSurface.Height(heights, layer, 1), Is.EqualTo(10 * crowding).Within(crowding == 1f ? 1e-6 : 0.15));
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

            Assert.That(metric.Failure, Does.Contain("sunk to 6"));
            Assert.That(metric.Evaluate()[0].Value, Is.NaN);
        }

        private static FluidSolverSettings Settings(bool half, double soundSquared) => new FluidSolverSettings
        {
            DomainSize = new Vector3(0.15f, 1.2f, 0.15f),
            Boundaries = new FluidBoundaries { Periodic = FluidAxes.X | FluidAxes.Z },
            Spacing = (float)(Depth / Layers),
            SupportRadius = (float)(2.25 * Depth / Layers),
            RestDensity = 1000f,
            TimeStep = 0.001f,
            Gravity = new Vector3(0, -(float)Gravity, 0),
        }.WithOwn(new ThesisSettings { PressureHalf = half, Stiffness = (float)(half ? 2 * soundSquared : soundSquared) });

        private static HydrostaticMetric Watched(in FluidSolverSettings settings, double height, Func<double, double> pressure, float speed,
            double density)
        {
            var metric = new HydrostaticMetric(settings, Depth, Layer, Begin);
            for (int s = 0; s < 6; s++) metric.Sample(0.4 * s, Column(height, pressure, speed, density));
            return metric;
        }

        // Layers in equal steps from the floor at y = −0.6 to a surface at height, half a spacing above the last.
        private static FluidSnapshot Column(double height, Func<double, double> pressure, float speed, double density)
        {
            double top = height - 0.5 * Depth / Layers;
            double Above(int i) => 0.5 * Depth / Layers + (top - 0.5 * Depth / Layers) * (i / Layer) / (Layers - 1);
            return WallCaseStates.State(Layers * Layer, i => new Vector3(0.05f * (i % 3), (float)(Above(i) - 0.6), 0.05f * (i / 3 % 3)),
                i => new Vector3(i % 2 == 0 ? speed : -speed, 0, 0), i => density, i => pressure(height - Above(i)));
        }
    }
}
