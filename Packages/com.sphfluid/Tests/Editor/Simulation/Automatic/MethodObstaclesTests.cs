using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Physics that act in a liquid keep out a method that lacks them, with the reason in the choice.</summary>
    public sealed class MethodObstaclesTests
    {
        // Robust fits, 6 substeps of 0.1 ms; Standard, at 1 ms a step, does not.
        private const float Budget = 0.65f;

        private SimulationRig rig;
        private MadeUpCosts costs;
        private FluidSimulation simulation;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig(1f / 60f);
            costs = new MadeUpCosts();
            foreach (string variant in new[] { "", "+tension", "+viscous", "+viscous+tension" })
            {
                costs.Set(FluidMethodKind.Standard, 1.0, variant: variant);
            }
            costs.Set(FluidMethodKind.Robust, 0.1);
            simulation = rig.Create();
            simulation.Method = FluidMethodKind.Automatic;
            simulation.FrameBudget = Budget;
        }

        [TearDown]
        public void TearDown()
        {
            costs.Dispose();
            rig.Dispose();
        }

        // σ = ρ g L² has the capillary length L.
        [TestCase(1.01, true)]
        [TestCase(0.99, false)]
        [TestCase(0.0, false)]
        public void SurfaceTensionKeepsRobustOutWhereItActs(double lengthOverSpacing, bool acts)
        {
            simulation.UseSceneGravity = false;
            simulation.Gravity = new Vector3(0f, -9.81f, 0f);
            double length = lengthOverSpacing * SimulationRig.Spacing;
            rig.Profile.SurfaceTension = (float)(rig.Profile.RestDensity * 9.81 * length * length);
            FluidMethodChoice choice = Choice();
            Assert.That(choice.Method, Is.EqualTo(acts ? FluidMethodKind.Standard : FluidMethodKind.Robust));
            Assert.That(ObstacleOfRobust(choice),
                Is.EqualTo(acts ? "has no surface tension, which acts in this liquid at a spacing of 50 mm" : null));
            if (acts)
            {
                Assert.That(choice.Reason, Does.Contain("Robust has no surface tension, which acts in this liquid at a spacing of 50 mm."));
            }
        }

        [Test]
        public void WithoutGravitySurfaceTensionActsWhereItIsAskedFor()
        {
            simulation.UseSceneGravity = false;
            simulation.Gravity = Vector3.zero;
            rig.Profile.SurfaceTension = 0.07f;
            Assert.That(ObstacleOfRobust(Choice()), Is.Null, "too coarse");
            rig.Profile.TensionAtAnySpacing = true;
            Assert.That(ObstacleOfRobust(Choice()), Does.StartWith("has no surface tension"));
        }

        [Test]
        public void ViscosityKeepsRobustOutWhereStandardSolvesForIt()
        {
            rig.Profile.SurfaceTension = 0f;
            int thin = 0, thick = 0;
            for (float viscosity = 1e-6f; viscosity < 20f; viscosity *= 10f)
            {
                rig.Profile.KinematicViscosity = viscosity;
                FluidMethodChoice choice = Choice();
                bool isSolved = Standard().Own<StandardSettings>().ImplicitViscosity;
                thick += isSolved ? 1 : 0;
                thin += isSolved ? 0 : 1;
                Assert.That(choice.Method, Is.EqualTo(isSolved ? FluidMethodKind.Standard : FluidMethodKind.Robust), $"{viscosity} m²/s");
                Assert.That(ObstacleOfRobust(choice) != null, Is.EqualTo(isSolved), $"{viscosity} m²/s");
            }
            Assert.That(thin > 0 && thick > 0, "there were both");
            Assert.That(Choice().Reason, Does.Contain("Robust has no implicit viscosity, which this liquid of 10 m²/s needs."));
        }

        [TestCase(1.01, false)]
        [TestCase(3.0, true)]
        public void ASpacingAtWhichTheTensionWouldActNoMoreIsNotProposed(double lengthOverSpacing, bool proposed)
        {
            double length = lengthOverSpacing * SimulationRig.Spacing;
            rig.Profile.SurfaceTension = (float)(rig.Profile.RestDensity * Physics.gravity.magnitude * length * length);
            FluidMethodChoice choice = Choice();
            Assert.That(choice.FitsBudget, Is.False);
            if (proposed) Assert.That(choice.ProposedSpacing, Is.InRange(1.02f * SimulationRig.Spacing, (float)length));
            else Assert.That(choice.ProposedSpacing, Is.Zero);
            Assert.That(simulation.Validate().Single(m => m.Issue == FluidIssue.MethodChoice).Cure, Does.Contain("Frame Budget of"));
        }

        [Test]
        public void TheChecksMessageHasTheReason()
        {
            rig.Profile.SurfaceTension = 50f;
            FluidMessage message = simulation.Validate().Single(m => m.Issue == FluidIssue.MethodChoice);
            Assert.That(message.Severity, Is.EqualTo(FluidSeverity.Warning));
            Assert.That(message.Text, Does.StartWith("Method in use: Standard").And.Contain("Robust has no surface tension"));
        }

        [Test]
        public void RobustIsNotPickedEitherWhereStandardCannotRun()
        {
            rig.Profile.SurfaceTension = 50f;
            FluidShaderSet without = TestShaders.Without(TestShaders.PackageSet, "StandardDensity");
            rig.Profile.Shaders = without;
            try
            {
                Assert.That(Choice(), Is.Null);
                FluidMessage message = simulation.Validate().Single(m => m.Issue == FluidIssue.MethodChoice);
                Assert.That(message.Severity, Is.EqualTo(FluidSeverity.Warning));
                Assert.That(message.Text,
                    Does.StartWith("No method has all that the simulation uses: it runs by Robust, without some of it.")
                    .And.Contain("Standard has shaders that the shader set lacks. Robust has no surface tension"));
                Assert.That(message.Cure, Is.Not.Empty);
            }
            finally
            {
                Object.DestroyImmediate(without);
            }
        }

        [Test]
        public void TheMethodsThatHaveAFeatureAreThoseThatAskForIt()
        {
            FluidRuleInput input = FluidRuleInput.Water;
            (input.DomainSize, input.Spacing, input.LiquidHeight, input.LiquidDepth) = (Vector3.one, 0.02f, 0.1f, 0.1f);
            (input.SurfaceTension, input.KinematicViscosity) = (50f, 10f);
            foreach (FluidMethod method in FluidMethods.All)
            {
                Assert.That(method.AskedBy(input) & ~method.Features, Is.EqualTo(FluidMethodFeatures.None),
                    $"{method.Kind} asks for what it lacks");
            }
            Assert.That(FluidMethods.Get(FluidMethodKind.Standard).AskedBy(input),
                Is.EqualTo(FluidMethodFeatures.SurfaceTension | FluidMethodFeatures.ImplicitViscosity));
        }

        private static string ObstacleOfRobust(FluidMethodChoice choice) =>
            choice.Considered.Single(c => c.Method == FluidMethodKind.Robust).Obstacle;

        private FluidMethodChoice Choice() => FluidSimulationChecks.PreviewChoice(simulation);

        // The constants that the same liquid has by the method Standard.
        private FluidSolverSettings Standard()
        {
            simulation.Method = FluidMethodKind.Standard;
            FluidSimulationChecks.Preview(simulation, out FluidSolverSettings? constants);
            simulation.Method = FluidMethodKind.Automatic;
            return constants.Value;
        }
    }
}
