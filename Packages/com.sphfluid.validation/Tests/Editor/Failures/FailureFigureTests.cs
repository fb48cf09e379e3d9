using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Failures against the figures that theory gives: lattice sums, limits of steps, heights of columns.</summary>
    public sealed class FailureFigureTests
    {
        private FluidShaderSet shaders;

        [SetUp]
        public void CreateShaders() => shaders = FailureShaders.Create();

        [TearDown]
        public void DestroyShaders() => Object.DestroyImmediate(shaders);

        [TestCase(2f, 0.81, 0.65)]
        [TestCase(3f, 0.71, 0.50)]
        [TestCase(4f, 0.65, 0.43)]
        public void FacesAndEdgesOfALatticeFindTooLittleDensity(float ratio, double face, double edge)
        {
            DensityFailures.Layer(DensityFailures.Deficiency(ratio).Run(true, shaders), out double atFace, out double atEdge);
            Assert.That(atFace, Is.EqualTo(face).Within(0.01), "in the middle of a face");
            Assert.That(atEdge, Is.EqualTo(edge).Within(0.01), "at an edge");
        }

        [TestCase(2f, 0.81)]
        [TestCase(1.69f, 0.64)]
        public void WithoutItselfALatticeFindsTooLittleDensity(float ratio, double density)
        {
            FailureResult result = DensityFailures.SelfTerm(ratio).Run(false, shaders);
            Assert.That(result.Figure, Is.EqualTo(density).Within(0.01));
            Assert.That(result.Names(FluidFailure.SelfTermMissing), Is.True, result.Named);
        }

        [Test]
        public void TheBorderOfTheTimeStepIsWhereTheLatticeDiverges()
        {
            FailureExperiment around = StepFailures.TimeStep(1.42, 1.33);
            around.Failing.Steps = around.Cured.Steps = 60;
            FailureResult beyond = around.Run(false, shaders), cured = around.Run(true, shaders);
            Assert.That(beyond.Names(around.Failure), beyond.Named);
            Assert.That(cured.Names(around.Failure), Is.False, cured.Named);
            Assert.That(beyond.Figure, Is.GreaterThan(0.2), "dt √k/R = 1.42");
            Assert.That(cured.Figure, Is.LessThan(1e-3), "1.33");
        }

        [Test]
        public void TheBorderOfViscosityIsWhereTheLatticeDiverges()
        {
            FailureExperiment around = StepFailures.Viscosity(0.131, 0.125);
            FailureResult beyond = around.Run(false, shaders);
            Assert.That(beyond.Figure, Is.GreaterThan(5.0), "ν dt/R² = 0.131");
            Assert.That(beyond.EndStatistics.Checkerboard, Is.GreaterThan(0.8), "neighbours move against each other");
            Assert.That(around.Run(true, shaders).Figure, Is.LessThan(1.05), "0.125");
        }

        [Test]
        public void TheViscosityOfTheRuleGoesWithTheSpacing()
        {
            double[] byRule = new double[2], ofLiquid = new double[2];
            int[] cells = { 6, 12 };
            for (int i = 0; i < cells.Length; i++)
            {
                FailureExperiment experiment = StepFailures.NumericalViscosity(cells[i]);
                byRule[i] = StepFailures.DecayViscosity(experiment.Run(false, shaders));
                ofLiquid[i] = StepFailures.DecayViscosity(experiment.Run(true, shaders));
            }
            Assert.That(byRule[0] / byRule[1], Is.EqualTo(2.0).Within(0.4), "twice the spacing, twice the viscosity");
            Assert.That(ofLiquid[0] / ofLiquid[1], Is.EqualTo(1.0).Within(0.2), "a liquid's own stays");
        }

        [Test]
        public void PairsInTheBulkPartAtAnySupportRadius()
        {
            FailureRun run = InteractionFailures.PairsInTheBulk();
            run.Steps = 8;
            FailureResult result =
                new FailureExperiment("pairs", FluidFailure.Pairing, run, run, "", r => r.EndStatistics.Clumped).Run(false, shaders);
            Assert.That(result.Statistics[0].Clumped, Is.EqualTo(run.Start.Length), "all at the start");
            Assert.That(result.Names(FluidFailure.Pairing), Is.True, result.Named);
            Assert.That(result.Figure, Is.Zero, "at the end");
        }

        [Test]
        public void ThrownParticlesStayBeforeASheetUpToTheLimit([Values(0.1f, 0.4f)] float displacement, [Values(0f, 9.81f)] float gravity)
        {
            FailureRun run = WallFailures.Drop(displacement, gravity);
            FailureResult result =
                new FailureExperiment("thrown", FluidFailure.Tunnelling, run, run, "", WallFailures.Behind).Run(false, shaders);
            Assert.That(result.Statistics[0].MaxSpeed * result.Settings.TimeStep,
                Is.EqualTo(displacement * result.Settings.Spacing).Within(1).Percent, "spacings a step");
            Assert.That(result.States[0].LocalPositions.Max(p => p.y), Is.LessThan(displacement * result.Settings.Spacing * run.Steps),
                "all can reach the sheet");
            Assert.That(result.Figure, Is.Zero, "share behind the sheet");
        }
    }
}
