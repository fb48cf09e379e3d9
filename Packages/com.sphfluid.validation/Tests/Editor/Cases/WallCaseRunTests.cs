using System;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>The cases between walls on the GPU, coarse: what the thesis method is known to give.</summary>
    public sealed class WallCaseRunTests
    {
        private FluidShaderSet shaders;

        [SetUp]
        public void CreateShaders() => shaders = TestShaders.CreateSet();

        [TearDown]
        public void DestroyShaders() => UnityEngine.Object.DestroyImmediate(shaders);

        [Test]
        public void PressureReadsTwiceWithTheHalfOfEquation13()
        {
            var flow = new HydrostaticCase();
            CaseParameters parameters = At(flow, 10, 4);
            CaseSetup setup = flow.Build(parameters);
            HydrostaticMetric half = WallCaseRig.Shorter(setup, 2.5, 4.5);
            CaseResult withHalf = WallCaseRig.Run(flow.Name, setup, half, shaders);
            ThesisSwitches full = ThesisSwitches.Corrected;
            full.PressureHalf = false;
            full.OctantSearch = false;
            setup.Settings = setup.Settings.With(full);
            HydrostaticMetric whole = WallCaseRig.Shorter(setup, 2.5, 4.5);
            CaseResult without = WallCaseRig.Run(flow.Name, setup, whole, shaders);

            Assert.That(withHalf.Failure, Is.Null);
            Assert.That(without.Failure, Is.Null);
            double read = WallCaseStates.Named(half, "slope/(ρg), as read");
            Assert.That(read, Is.InRange(1.95, 2.7));
            Assert.That(WallCaseStates.Named(whole, "slope/(ρg), as read"), Is.EqualTo(0.5 * read).Within(0.1));
            Assert.That(half.Evaluate()[0].Value, Is.EqualTo(Math.Abs(0.5 * read - 1)).Within(1e-9), "what pushes");
            Assert.That(WallCaseStates.Named(half, "height lost beyond the equation of state's"), Is.InRange(0.03, 0.12),
                "about a spacing of ten");
        }

        [Test]
        public void ThePrintedLimitLetsTheColumnCollapse()
        {
            // 6.3.3 as printed limits the fluid's own acceleration to √(gH) = 3.1 m/s², less than gravity.
            var flow = new HydrostaticCase();
            CaseParameters parameters = flow.Base(CaseMethod.Find("thesis-printed"));
            parameters.Resolution = 12;
            CaseResult result = WallCaseRig.Run(flow, parameters, shaders, out _);

            Assert.That(result.Failure, Does.Contain("sunk"));
            Assert.That(result.SimulatedSeconds, Is.LessThan(5 * Math.Sqrt(1 / 9.81)));
        }

        [Test]
        public void TheWaveSwingsAtItsPeriodAndIsDampedTooMuch()
        {
            var flow = new StandingWaveCase();
            CaseParameters parameters = At(flow, 8, 6);
            CaseSetup setup = flow.Build(parameters);
            setup.Duration *= 0.6;
            CaseResult result = WallCaseRig.Run(flow, parameters, setup, shaders, out CaseMetric metric);

            Assert.That(result.Failure, Is.Null);
            Assert.That(result.Errors[0].Value, Is.LessThan(0.1));
            Assert.That(WallCaseStates.Named(metric, "numerical viscosity/ν"), Is.InRange(0.5, 3.0));
        }

        [Test]
        public void PoiseuilleAndCouetteFlowsStartUp()
        {
            var poiseuille = new PoiseuilleCase();
            var couette = new CouetteCase();

            Assert.That(WallCaseRig.StartUpError(poiseuille, At(poiseuille, 8, 10)), Is.LessThan(0.05));
            Assert.That(WallCaseRig.StartUpError(couette, At(couette, 8, 10)), Is.LessThan(0.03));
        }

        [Test]
        public void TheThesisWallsLeaveCouetteLiquidAtRest()
        {
            var couette = new CouetteCase { NoSlip = false };
            CaseSetup setup = couette.Build(At(couette, 8, 10));
            setup.Duration = 20.0;
            var states = new CaseStates.Recorder();
            WallCaseRig.Run(couette.Name, setup, states, shaders);

            double square = states.States.Last().Velocities.Average(v => (double)v.x * v.x);
            Assert.That(Math.Sqrt(square), Is.LessThan(0.02 * 0.1), "a fiftieth of the wall's speed");
        }

        // Corrected, coarse.
        private static CaseParameters At(ValidationCase flow, int resolution, double soundSpeedRatio)
        {
            CaseParameters parameters = flow.Base(CaseMethod.Find("thesis"));
            parameters.Resolution = resolution;
            parameters.SoundSpeedRatio = soundSpeedRatio;
            return parameters;
        }
    }
}
