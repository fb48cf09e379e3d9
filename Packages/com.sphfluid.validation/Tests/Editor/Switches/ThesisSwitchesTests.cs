using System;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// What each printed form of the thesis does, seen beside the form that works; Documentation~/printed-forms.md shows the pictures,
    /// which go on for longer.
    /// </summary>
    public sealed class ThesisSwitchesTests
    {
        private FluidShaderSet shaders;
        private SwitchResult column;

        [SetUp]
        public void CreateShaders() => shaders = TestShaders.CreateSet();

        [TearDown]
        public void DestroyShaders() => UnityEngine.Object.DestroyImmediate(shaders);

        [Test]
        public void StiffnessFollowsTheHalf()
        {
            FluidSolverSettings corrected = TestSettings.ByRule(Vector3.one, 0.05f);
            ThesisSwitches full = ThesisSwitches.Corrected;
            full.PressureHalf = false;
            FluidSolverSettings settings = corrected.With(full);
            Assert.That(settings.Own<ThesisSettings>().Stiffness, Is.EqualTo(0.5f * corrected.Own<ThesisSettings>().Stiffness), "k = c²");
            Assert.That(settings.SoundSpeed, Is.EqualTo(corrected.SoundSpeed).Within(1e-5 * corrected.SoundSpeed));
            Assert.That(settings.With(ThesisSwitches.Corrected), Is.EqualTo(corrected), "and back, k = 2 c²");
        }

        [Test]
        public void CorrectedIsWhatTheRulesGive()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Vector3.one, 0.05f);
            Assert.That(settings.With(ThesisSwitches.Corrected), Is.EqualTo(settings));
        }

        [Test]
        public void ThePrintedMethodHasEverySwitchAsPrinted()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Vector3.one, 0.05f);
            settings.Method = FluidMethodKind.ThesisPrinted;
            using (var solver = new FluidSolver(settings, shaders, Pair()))
            {
                Assert.That(solver.Settings, Is.EqualTo(settings.With(ThesisSwitches.Printed)));
                settings.Viscosity *= 2f;
                solver.ApplySettings(settings);
                Assert.That(solver.Settings, Is.EqualTo(settings.With(ThesisSwitches.Printed)), "after a change");
                Assert.That(solver.Settings.Own<ThesisSettings>().SelfDensity || solver.Settings.PressureClamp ||
                    solver.Settings.Own<ThesisSettings>().HalfKick, Is.False);
                Assert.That(solver.Settings.Own<ThesisSettings>().ForceTimesMass &&
                    solver.Settings.Own<ThesisSettings>().AccelerationLimitEnabled &&
                    solver.Settings.Own<ThesisSettings>().PressureHalf, Is.True);
            }
        }

        [Test]
        public void TheSearchCannotChangeWhileTheLiquidRuns()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Vector3.one, 0.05f);
            using (var solver = new FluidSolver(settings, shaders, Pair()))
            {
                settings.OctantSearch = false;
                Assert.That(() => solver.ApplySettings(settings), Throws.ArgumentException.With.Message.Contains("OctantSearch"));
            }
        }

        [Test]
        public void TheHalfWithoutDoubledStiffnessHalvesTheForce()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Vector3.one, 0.05f);
            settings.Viscosity = 0f;
            ThesisSwitches full = ThesisSwitches.Corrected;
            full.PressureHalf = false;
            FluidSolverSettings undoubled = settings;
            undoubled = undoubled.WithOwn((ref ThesisSettings own) => own.Stiffness *= 0.5f);
            double whole = Force(settings.With(full));
            Assert.That(whole, Is.GreaterThan(0.0));
            Assert.That(Force(undoubled), Is.EqualTo(0.5 * whole).Within(1e-5 * whole));
            Assert.That(Force(settings), Is.EqualTo(whole).Within(1e-5 * whole), "doubled");
        }

        [Test]
        public void EightCellsOfTheWrongSizeMakeAColumnBoil()
        {
            Assert.That(Printed(SwitchCatalogue.EightCells(), 0.7f).MeanSpeed,
                Is.GreaterThan(3.0 * Column(SwitchCatalogue.EightCells()).MeanSpeed));
        }

        [Test]
        public void WithoutItselfAParticleFindsTooLittleAndTheColumnShrinks()
        {
            Assert.That(Printed(SwitchCatalogue.SelfDensity(), 0.35f).MeanHeight,
                Is.LessThan(0.9 * Column(SwitchCatalogue.SelfDensity()).MeanHeight));
        }

        [Test]
        public void WithoutItselfABlockContractsInFreeFall()
        {
            Run(SwitchCatalogue.SelfDensityInFreeFall(), 0.05f, out SwitchResult corrected, out SwitchResult printed);
            double start = 0.025 * Math.Sqrt(3.0 * (9.0 * 9.0 - 1.0) / 12.0);
            Assert.That(corrected.Extent, Is.EqualTo(start).Within(0.05 * start));
            Assert.That(printed.Extent, Is.LessThan(0.92 * start));
            Assert.That(printed.MeanHeight, Is.EqualTo(corrected.MeanHeight).Within(1e-3), "both fall alike");
        }

        [Test]
        public void WithoutTheClampASheetDrawsItselfIntoClumps()
        {
            Run(SwitchCatalogue.PressureClamp(), 0.15f, out SwitchResult corrected, out SwitchResult printed);
            Assert.That(corrected.Clumped(0.5f), Is.Zero);
            Assert.That(corrected.Pressure.Min(), Is.Zero);
            Assert.That(printed.Clumped(0.5f), Is.GreaterThan(0.3));
            Assert.That(printed.Pressure.Min(), Is.LessThan(0f));
        }

        [Test]
        public void ThePrintedLimitCannotCarryTheLiquid()
        {
            SwitchResult corrected = Column(SwitchCatalogue.AccelerationLimit()),
                printed = Printed(SwitchCatalogue.AccelerationLimit(), 0.3f);
            Assert.That(corrected.Counters.AccelerationLimitHits, Is.Zero);
            Assert.That(printed.Settings.Own<ThesisSettings>().AccelerationLimit, Is.LessThan(9.81f));
            Assert.That(printed.Counters.AccelerationLimitHits, Is.GreaterThan(10000));
            Assert.That(printed.MeanHeight, Is.LessThan(0.25 * corrected.MeanHeight));
        }

        [Test]
        public void ForceTimesMassGoesWithTheCubeOfTheSpacing()
        {
            Run(SwitchCatalogue.ForceTimesMass(), 0.07f, out SwitchResult corrected, out SwitchResult printed);
            Assert.That(printed.MeanHeight, Is.LessThan(0.75 * corrected.MeanHeight), "does not hold");
            foreach (float spacing in new[] { 0.0025f, 0.01f, 0.04f })
            {
                FluidSolverSettings settings = TestSettings.ByRule(20f * spacing * Vector3.one, spacing);
                settings = settings.WithOwn((ref ThesisSettings own) => own.AccelerationLimitEnabled = false);
                settings = settings.WithOwn((ref ThesisSettings own) => own.ForceTimesMass = true);
                Double3 printedAcceleration = Acceleration(settings, out float density);
                settings = settings.WithOwn((ref ThesisSettings own) => own.ForceTimesMass = false);
                double ratio = printedAcceleration.Length / Acceleration(settings, out _).Length;
                Assert.That(ratio, Is.EqualTo(settings.ParticleMass * density).Within(1e-4).Percent, $"m ρ at {spacing} m");
            }
        }

        [Test]
        public void WithoutTheHalfKickAFallIsAheadByHalfAStepsSpeed()
        {
            SwitchExperiment experiment = SwitchCatalogue.HalfKick();
            Run(experiment, experiment.Seconds, out SwitchResult corrected, out SwitchResult printed);
            double expected = 0.5 * 9.81 * experiment.Seconds * experiment.Printed.TimeStep;
            Assert.That(corrected.MeanHeight - printed.MeanHeight, Is.EqualTo(expected).Within(1e-4), "½ g t dt");
        }

        [Test]
        public void TheWholePrintedTextDoesNotMakeALiquid()
        {
            // The corrected method leaves 0.6 of the height by then.
            SwitchExperiment experiment = SwitchCatalogue.AllPrinted();
            float start = experiment.Start.Average(p => p.Position.y) + 0.5f * experiment.Printed.DomainSize.y;
            Assert.That(Printed(experiment, 0.15f).MeanHeight, Is.LessThan(0.35 * start));
        }

        private static FluidParticle[] Pair() => ParticleSets.Lattice(new Vector3Int(2, 1, 1), 0.05f, 0f, 1);

        private void Run(SwitchExperiment experiment, float seconds, out SwitchResult corrected, out SwitchResult printed)
        {
            Assert.That(experiment.Start.Length, Is.LessThanOrEqualTo(2000), "small");
            corrected = Lasting(experiment, seconds).Run(false, shaders);
            printed = Printed(experiment, seconds);
        }

        private SwitchResult Printed(SwitchExperiment experiment, float seconds)
        {
            SwitchResult printed = Lasting(experiment, seconds).Run(true, shaders);
            TestContext.WriteLine(
                $"{experiment.Name}: height {printed.MeanHeight:g4} m, speed {printed.MeanSpeed:g4} m/s, slope {printed.PressureSlope:g4}");
            return printed;
        }

        // Several experiments have the same corrected side: a column that has come to rest, run once.
        private SwitchResult Column(SwitchExperiment experiment)
        {
            SwitchExperiment calm = Lasting(SwitchCatalogue.EightCells(), 0.7f);
            Assert.That(experiment.Corrected, Is.EqualTo(calm.Corrected));
            return column = column ?? calm.Run(false, shaders);
        }

        private static SwitchExperiment Lasting(SwitchExperiment experiment, float seconds) =>
            new SwitchExperiment(experiment.Name, experiment.Start, seconds, experiment.Corrected,
                experiment.Printed)
            { EightCellsOfSmoothLength = experiment.EightCellsOfSmoothLength };

        // On the corner particle of a squeezed lattice.
        private static double Force(in FluidSolverSettings settings)
        {
            using (var rig = new ThesisRig(settings, Squeezed(settings)))
            {
                rig.RunNeighbourSetup();
                rig.RunForce();
                return ((Vector3)rig.ReadForce()[First(rig)]).magnitude;
            }
        }

        private static Double3 Acceleration(FluidSolverSettings settings, out float density)
        {
            settings.Gravity = Vector3.zero;
            using (var rig = new ThesisRig(settings, Squeezed(settings)))
            {
                rig.RunNeighbourSetup();
                rig.RunForce();
                rig.RunAcceleration();
                int first = First(rig);
                density = rig.ReadDensity()[first];
                return (Vector3)rig.ReadAcceleration()[first];
            }
        }

        private static FluidParticle[] Squeezed(in FluidSolverSettings settings) =>
            ParticleSets.Lattice(new Vector3Int(5, 5, 5), 0.7f * settings.Spacing, 0f, 1);

        private static int First(ThesisRig rig) => Array.FindIndex(rig.ReadParticles(), p => p.Id == 0);
    }
}
