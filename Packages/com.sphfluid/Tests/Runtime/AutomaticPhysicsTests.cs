using System.Collections;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>
    /// A liquid whose method is chosen, with physics that only Standard has: at the start, and when they come to act in play.
    /// </summary>
    public sealed class AutomaticPhysicsTests
    {
        // Acts at the rig's spacing: its capillary length is 7 cm.
        private const float StrongTension = 50f;

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
            simulation.FrameBudget = 0.65f;
        }

        [TearDown]
        public void TearDown()
        {
            costs.Dispose();
            rig.Dispose();
        }

        [Test]
        public void AStartTimesOnlyWhatCanBePickedAndSaysWhy()
        {
            costs.Set(FluidMethodKind.Standard, 1.0, variant: "+tension");
            rig.Profile.SurfaceTension = StrongTension;
            LogAssert.Expect(LogType.Warning, new Regex("Robust has no surface tension, which acts in this liquid at a spacing of 50 mm"));
            Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
            Assert.That(simulation.ActiveMethod, Is.EqualTo(FluidMethodKind.Standard));
            Assert.That(simulation.Solver.Settings.Own<StandardSettings>().SurfaceTension, Is.EqualTo(StrongTension));
            Assert.That(costs.Count, Is.EqualTo(1), "Robust was not timed");
        }

        [UnityTest]
        public IEnumerator PhysicsThatComeToActInPlayAreSaidAndTakenAtTheNextChoice()
        {
            costs.Set(FluidMethodKind.Standard, 1.0).Set(FluidMethodKind.Standard, 1.0, variant: "+tension")
                .Set(FluidMethodKind.Robust, 0.1);
            Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
            Assert.That(simulation.ActiveMethod, Is.EqualTo(FluidMethodKind.Robust));
            yield return null;
            FluidSolver solver = simulation.Solver;
            rig.Profile.SurfaceTension = StrongTension;
            for (int i = 0; i < 3; i++) yield return null;
            Assert.That(simulation.Solver, Is.SameAs(solver), "the method stays");
            Assert.That(simulation.Messages.Last(m => m.Issue == FluidIssue.MethodChoice).Text,
                Does.StartWith("By the changed settings another method than Robust, which stays in use, would be picked: Standard").And
                    .Contain("Robust has no surface tension"));
            LogAssert.Expect(LogType.Warning, new Regex("Method in use: Standard.*Robust has no surface tension"));
            Assert.That(simulation.ChooseMethodAgain());
            Assert.That(simulation.ActiveMethod, Is.EqualTo(FluidMethodKind.Standard));
        }
    }
}
