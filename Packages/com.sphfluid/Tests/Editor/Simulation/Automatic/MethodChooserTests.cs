using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What is picked for a simulation by made-up costs, what is said of it, and what is proposed.</summary>
    public sealed class MethodChooserTests
    {
        private SimulationRig rig;
        private MadeUpCosts costs;
        private FluidSimulation simulation;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig(1f / 60f);
            costs = new MadeUpCosts();
            simulation = rig.Create();
            simulation.Method = FluidMethodKind.Automatic;
        }

        [TearDown]
        public void TearDown()
        {
            costs.Dispose();
            rig.Dispose();
        }

        [Test]
        public void TheProfilesAccuracyWhereItFits()
        {
            costs.Set(FluidMethodKind.Standard, 0.01);
            FluidMethodChoice choice = Choose(20f);
            Assert.That(choice.Method, Is.EqualTo(FluidMethodKind.Standard));
            Assert.That(choice.Pick.MaxCompression, Is.EqualTo(rig.Profile.MaxCompression));
            Assert.That(choice.FitsBudget && choice.IsMeasured);
            Assert.That(choice.Pick.MillisecondsAFrame, Is.EqualTo(0.01 * choice.Pick.StepsAFrame).Within(1e-12));
            Assert.That(choice.ProposedSpacing, Is.Zero);
            Assert.That(choice.Particles, Is.EqualTo(64));
        }

        [Test]
        public void ThreeTimesTheCompressionWhereOnlyThatFits()
        {
            costs.Set(FluidMethodKind.Standard, 1.0);
            FluidMethodChoice all = Choose(1000f);
            FluidMethodCandidate[] ways = Choose(0.001f).Considered.Where(c => c.Method == FluidMethodKind.Standard).ToArray();
            Assert.That(ways.Length, Is.EqualTo(2));
            Assert.That(ways[0].StepsAFrame, Is.EqualTo(all.Pick.StepsAFrame));
            FluidMethodChoice choice = Choose((float)(0.5 * (ways[0].StepsAFrame + ways[1].StepsAFrame)));
            Assert.That(choice.Pick.MaxCompression, Is.EqualTo(3f * rig.Profile.MaxCompression).Within(1e-6f));
            Assert.That(choice.FitsBudget);
            Assert.That(choice.Reason, Does.Contain("12 % compression").And.Contain($"Standard would take {ways[0].StepsAFrame:0} steps"));
        }

        [Test]
        public void RobustWhereStandardDoesNotFit()
        {
            costs.Set(FluidMethodKind.Standard, 1.0).Set(FluidMethodKind.Robust, 0.1);
            FluidMethodChoice choice = Choose(0.65f);
            Assert.That(choice.Method, Is.EqualTo(FluidMethodKind.Robust));
            Assert.That(choice.Pick.Substeps, Is.EqualTo(6));
            Assert.That(choice.FitsBudget);
            Assert.That(choice.Considered.Count, Is.EqualTo(3));
            Assert.That(choice.Reason,
                Does.StartWith("Robust, 6 substeps a frame: 0.60 ms of the 0.65 ms allowed").And.Contain("Standard would take").And
                    .Contain("Standard with 12 % compression would take"));
        }

        [Test]
        public void SoftRobustProposesACoarserSpacing()
        {
            costs.Set(FluidMethodKind.Standard, 100.0).Set(FluidMethodKind.Robust, 0.1);
            simulation.DomainSize = new Vector3(0.2f, 4f, 0.2f);
            simulation.GetComponentInChildren<FluidVolume>().Size = new Vector3(0.2f, 3.9f, 0.2f);
            costs.Set(FluidMethodKind.Robust, 0.1, particles: 1248);
            costs.Set(FluidMethodKind.Standard, 100.0, particles: 1248);
            FluidMethodChoice choice = Choose(0.45f);
            Assert.That(choice.Method, Is.EqualTo(FluidMethodKind.Robust));
            Assert.That(choice.FitsBudget && !choice.Pick.IsStiffEnough);
            Assert.That(choice.ProposedSpacing, Is.GreaterThan(simulation.Spacing));
            Assert.That(choice.Reason, Does.Contain("too soft for this depth"));
        }

        [Test]
        public void WithoutCostsNothingIsClaimed()
        {
            FluidMethodChoice choice = Choose(4f);
            Assert.That(choice.IsMeasured, Is.False);
            Assert.That(choice.FitsBudget, Is.False);
            Assert.That(choice.Method, Is.EqualTo(FluidMethodKind.Standard));
            Assert.That(choice.Reason, Does.Contain("measured at the start"));
            Assert.That(costs.Count, Is.Zero, "a check measures nothing");
        }

        [Test]
        public void CostsOfMuchSmallerLiquidAreNotTrusted()
        {
            costs.Set(FluidMethodKind.Standard, 0.01, particles: 16);
            Assert.That(Choose(20f).IsMeasured, Is.False);
        }

        [Test]
        public void TheMethodsOfTheThesisAreNeverPicked()
        {
            foreach (FluidMethod method in FluidMethods.All) costs.Set(method.Kind, method.MayBePicked ? 100.0 : 1e-6);
            foreach (float budget in new[] { 0.001f, 1f, 1000f })
            {
                FluidMethodChoice choice = Choose(budget);
                Assert.That(FluidMethods.Get(choice.Method).MayBePicked);
                Assert.That(choice.Considered.All(c => FluidMethods.Get(c.Method).MayBePicked));
            }
        }

        [Test]
        public void ABudgetThatNothingFitsProposesACoarserSpacingAndSetsNone()
        {
            foreach (FluidMethod method in FluidMethods.All) costs.Set(method.Kind, 2.0);
            float before = simulation.Spacing;
            FluidMethodChoice choice = Choose(1f);
            Assert.That(choice.FitsBudget, Is.False);
            Assert.That(choice.Pick.MillisecondsAFrame, Is.EqualTo(choice.Considered.Min(c => c.MillisecondsAFrame)));
            Assert.That(choice.ProposedSpacing, Is.GreaterThan(before));
            Assert.That(simulation.Spacing, Is.EqualTo(before));
            FluidMessage message = simulation.Validate().Single(m => m.Issue == FluidIssue.MethodChoice);
            Assert.That(message.Severity, Is.EqualTo(FluidSeverity.Warning));
            Assert.That(message.ToString(),
                Does.Contain("more than the 1 ms allowed").And.Contain($"Set Particle Spacing to {choice.ProposedSpacing} m").And
                    .Contain("Frame Budget of"));
        }

        [Test]
        public void TheProposedSpacingFits()
        {
            foreach (FluidMethod method in FluidMethods.All) costs.Set(method.Kind, 0.1);
            simulation.FrameBudget = 0.12f;
            FluidMethodChoice choice = FluidSimulationChecks.PreviewChoice(simulation);
            Assert.That(choice.FitsBudget, Is.False);
            // Costs at the proposed spacing are in proportion to the particles there.
            costs.Dispose();
            costs = new MadeUpCosts();
            foreach (FluidMethod method in FluidMethods.All)
            {
                costs.Set(method.Kind, 0.1 * choice.ProposedParticles / 64.0, particles: choice.ProposedParticles);
            }
            simulation.Spacing = choice.ProposedSpacing;
            FluidMethodChoice there = FluidSimulationChecks.PreviewChoice(simulation);
            Assert.That(there, Is.Not.Null);
            // Layers come and go whole, so the lattice may hold a few more particles than the proposal says.
            Assert.That(there.Considered.Min(c => c.StepsAFrame * c.MillisecondsAStep),
                Is.LessThan(0.12 * there.Particles / (double)choice.ProposedParticles + 1e-9));
        }

        [Test]
        public void ALargerBudgetIsNeverAnsweredByAWorseWay()
        {
            foreach (FluidMethod method in FluidMethods.All) costs.Set(method.Kind, 0.5);
            int before = int.MaxValue;
            for (float budget = 0.1f; budget < 100f; budget *= 1.15f)
            {
                FluidMethodChoice choice = Choose(budget);
                Assert.That(choice.Rank, Is.LessThanOrEqualTo(before), $"{budget} ms");
                if (choice.FitsBudget) before = choice.Rank;
            }
            Assert.That(before, Is.Zero);
        }

        [Test]
        public void ASlowerFrameRateNeedsMoreOfALargerFrame()
        {
            costs.Set(FluidMethodKind.Standard, 0.01);
            double sixty = Choose(20f).Pick.StepsAFrame;
            simulation.BudgetFrameRate = 30f;
            FluidMethodChoice thirty = Choose(20f);
            Assert.That(thirty.FrameRate, Is.EqualTo(30.0));
            Assert.That(thirty.Pick.StepsAFrame, Is.EqualTo(2.0 * sixty).Within(1.0));
        }

        [Test]
        public void CostsWithBodiesAreTheirOwn()
        {
            costs.Set(FluidMethodKind.Standard, 0.01).Set(FluidMethodKind.Standard, 0.02, hasBodies: true);
            Assert.That(Choose(20f).Pick.MillisecondsAStep, Is.EqualTo(0.01).Within(1e-12));
            GameObject wall = rig.NewObject("Wall");
            wall.AddComponent<BoxCollider>().size = new Vector3(0.05f, 0.1f, 0.1f);
            wall.transform.position = new Vector3(0.17f, -0.1f, 0.1f);
            Physics.SyncTransforms();
            Assert.That(Choose(20f).Pick.MillisecondsAStep, Is.EqualTo(0.02).Within(1e-12));
        }

        [TestCase(0f)]
        [TestCase(-1f)]
        [TestCase(float.NaN)]
        [TestCase(float.PositiveInfinity)]
        public void ABudgetThatIsNoneIsAnErrorWithACure(float budget)
        {
            simulation.FrameBudget = budget;
            FluidMessage message = simulation.Validate().Single(m => m.Issue == FluidIssue.MethodChoice);
            Assert.That(message.Severity, Is.EqualTo(FluidSeverity.Error));
            Assert.That(message.ToString(), Does.Contain("frame budget").And.Contain("Give Frame Budget"));
        }

        [TestCase(-30f)]
        [TestCase(float.NaN)]
        public void AFrameRateThatIsNoneIsAnErrorWithACure(float rate)
        {
            simulation.BudgetFrameRate = rate;
            FluidMessage message = simulation.Validate().Single(m => m.Issue == FluidIssue.MethodChoice);
            Assert.That(message.Severity, Is.EqualTo(FluidSeverity.Error));
            Assert.That(message.ToString(), Does.Contain("Give Budget Frame Rate"));
        }

        [Test]
        public void ADeviceWithoutAMethodsKernelsIsSaid()
        {
            costs.Set(FluidMethodKind.Standard, 0.01);
            FluidShaderSet without = TestShaders.CreateSet();
            try
            {
                FluidSpec spec = simulation.Spec;
                spec.Profile.Shaders = ScriptableObject.CreateInstance<FluidShaderSet>();
                Assert.That(MethodObstacles.Find(spec, FluidMethods.Get(FluidMethodKind.Standard)), Does.Contain("shader set"));
                Object.DestroyImmediate(spec.Profile.Shaders);
                spec.Profile.Shaders = without;
                Assert.That(MethodObstacles.Find(spec, FluidMethods.Get(FluidMethodKind.Standard)), Is.Null);
                spec.Zones = new[] { default(ZoneSpec) };
                Assert.That(MethodObstacles.Find(spec, FluidMethods.Get(FluidMethodKind.Thesis)),
                    Is.EqualTo("has no force zones, which the simulation uses"));
            }
            finally
            {
                Object.DestroyImmediate(without);
            }
        }

        [Test]
        public void AnEmptyLiquidIsNotTimed()
        {
            costs.Set(FluidMethodKind.Standard, 0.01);
            FluidStart dry = new FluidStart(new System.Collections.Generic.List<FluidParticle>(), 0,
                LiquidExtent.Create(new LiquidShape[0], simulation.DomainSize), 0f);
            FluidMethodChoice choice = MethodChooser.Choose(simulation.Spec, dry, false,
                (in FluidSolverSettings settings) => throw new System.InvalidOperationException("timed"));
            Assert.That(choice.IsMeasured, Is.False);
        }

        [Test]
        public void ADeviceThatCannotBeTimedIsEstimatedAndSaid()
        {
            FluidStart start = new FluidStart(new System.Collections.Generic.List<FluidParticle>(), 1000,
                LiquidExtent.Create(new LiquidShape[0], simulation.DomainSize), 1f);
            FluidMethodChoice choice = MethodChooser.Choose(simulation.Spec, start, false, (in FluidSolverSettings settings) => null);
            Assert.That(choice.Pick.CostSource, Is.EqualTo(FluidCostSource.Estimated));
            // 5 ns a pass, 3 passes, 1000 particles.
            Assert.That(choice.Considered[0].MillisecondsAStep, Is.EqualTo(0.015).Within(1e-12));
            Assert.That(choice.Reason, Does.Contain("could not be timed").And.Contain("estimates"));
            Assert.That(costs.Count, Is.Zero, "an estimate is not kept");
        }

        private FluidMethodChoice Choose(float budget)
        {
            simulation.FrameBudget = budget;
            return FluidSimulationChecks.PreviewChoice(simulation);
        }
    }
}
