using System;
using System.Collections;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>A liquid whose method is chosen: at the start, by changed settings, again when asked, and through saves.</summary>
    public sealed class AutomaticMethodTests
    {
        private const float Frame = 1f / 60f;

        private SimulationRig rig;
        private MadeUpCosts costs;
        private FluidSimulation simulation;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig(Frame);
            costs = new MadeUpCosts();
            simulation = rig.Create();
            simulation.Method = FluidMethodKind.Automatic;
            simulation.FrameBudget = 1000f;
        }

        [TearDown]
        public void TearDown()
        {
            costs.Dispose();
            rig.Dispose();
        }

        [Test]
        public void AStartTimesWhatIsNotKnownAndSaysWhatItPicked()
        {
            Assert.That(simulation.MethodChoice, Is.Null);
            Start();
            FluidMethodChoice choice = simulation.MethodChoice;
            Assert.That(choice.Method, Is.EqualTo(FluidMethodKind.Standard), "a second for a frame of 64 particles");
            Assert.That(choice.Pick.CostSource, Is.EqualTo(FluidCostSource.MeasuredAtStart));
            Assert.That(choice.Pick.MillisecondsAStep, Is.GreaterThan(0.0));
            Assert.That(simulation.ActiveMethod, Is.EqualTo(choice.Method));
            Assert.That(simulation.Solver.Kind, Is.EqualTo(choice.Method));
            Assert.That(simulation.Method, Is.EqualTo(FluidMethodKind.Automatic), "what the user set stays");
            FluidMessage message = Choices().Single();
            Assert.That(message.Severity, Is.EqualTo(FluidSeverity.Info));
            Assert.That(message.Text, Does.StartWith("Method in use: Standard").And.Contain("timed at a start"));
            Assert.That(costs.Count, Is.EqualTo(1), "what comes after one that fits is not timed");
        }

        [Test]
        public void KnownCostsAreNotTimedAgain()
        {
            SetAll(0.001, inPlay: true);
            Start();
            Assert.That(simulation.MethodChoice.Pick.CostSource, Is.EqualTo(FluidCostSource.MeasuredInPlay));
            Assert.That(simulation.MethodChoice.Pick.MillisecondsAStep, Is.EqualTo(0.001).Within(1e-12));
        }

        [Test]
        public void ASofterPickRunsSofterAndTheProfileStays()
        {
            costs.Set(FluidMethodKind.Standard, 1.0);
            float asked = rig.Profile.MaxCompression;
            simulation.FrameBudget = SoftBudget();
            Start();
            Assert.That(simulation.MethodChoice.Pick.MaxCompression, Is.EqualTo(3f * asked).Within(1e-6f));
            float soft = simulation.Solver.Settings.SoundSpeed;
            simulation.FrameBudget = 1000f;
            Start();
            Assert.That(simulation.Solver.Settings.SoundSpeed / soft, Is.EqualTo(5f / 3f).Within(1e-3f));
            Assert.That(rig.Profile.MaxCompression, Is.EqualTo(asked));
        }

        [UnityTest]
        public IEnumerator AChangedBudgetActsAtOnceAndOnlyAnotherMethodStartsAgain()
        {
            costs.Set(FluidMethodKind.Standard, 1.0);
            Start();
            yield return null;
            yield return null;
            FluidSolver solver = simulation.Solver;
            float stiff = solver.Settings.SoundSpeed;
            simulation.FrameBudget = SoftBudget();
            yield return null;
            yield return null;
            Assert.That(simulation.Solver, Is.SameAs(solver), "the same method, softer, goes on");
            Assert.That(simulation.MethodChoice.Pick.Offer.AsTheProfileAsks, Is.False);
            Assert.That(solver.Settings.SoundSpeed, Is.LessThan(stiff));
            Assert.That(Choices().Length, Is.EqualTo(2));
        }

        [UnityTest]
        public IEnumerator TheChoiceStaysWhileNothingChanges()
        {
            costs.Set(FluidMethodKind.Standard, 1.0);
            simulation.FrameBudget = SoftBudget();
            Start();
            FluidMethodChoice choice = simulation.MethodChoice;
            costs.Set(FluidMethodKind.Standard, 1e-4); // better news that nobody asked for
            for (int i = 0; i < 10; i++) yield return null;
            Assert.That(simulation.MethodChoice, Is.SameAs(choice));
            Assert.That(Choices().Length, Is.EqualTo(1));
            Assert.That(simulation.ChooseMethodAgain());
            yield return null;
            Assert.That(simulation.MethodChoice.Pick.Offer.AsTheProfileAsks, "asked, it takes the news");
        }

        [UnityTest]
        public IEnumerator TheLiquidKeepsTimeWhateverTheMostSubstepsAre()
        {
            SetAll(1.0);
            simulation.MaxSubstepsPerFrame = 1;
            simulation.FrameBudget = 0.01f;
            LogAssert.Expect(LogType.Warning, new Regex("more than the 0.01 ms allowed"));
            Start();
            for (int i = 0; i < 30; i++) yield return null;
            Assert.That(simulation.StepCount, Is.GreaterThan(30));
            Assert.That(simulation.CapHits, Is.Zero);
            Assert.That(simulation.RealTimeFactor, Is.EqualTo(1.0).Within(1e-9));
            Assert.That(simulation.SimulatedTime, Is.EqualTo(30 * (double)Frame).Within(1.01 * Frame));
        }

        [UnityTest]
        public IEnumerator AMethodThatIsGivenIsTakenAtOnce()
        {
            costs.Set(FluidMethodKind.Standard, 0.001);
            Start();
            simulation.Method = FluidMethodKind.Thesis;
            yield return null;
            yield return null;
            Assert.That(simulation.Solver.Kind, Is.EqualTo(FluidMethodKind.Thesis));
            Assert.That(simulation.MethodChoice, Is.Null);
            Assert.Throws<InvalidOperationException>(() => simulation.ChooseMethodAgain());
            simulation.Method = FluidMethodKind.Automatic;
            yield return null;
            yield return null;
            Assert.That(simulation.Solver.Kind, Is.EqualTo(FluidMethodKind.Standard));
            Assert.That(simulation.MethodChoice, Is.Not.Null);
        }

        [UnityTest]
        public IEnumerator FeaturesAreThoseOfTheMethodInUse()
        {
            costs.Set(FluidMethodKind.Standard, 0.001);
            Start();
            yield return null;
            simulation.AddImpulse(Vector3.zero, 0.1f, new Vector3(0.1f, 0f, 0f));
            simulation.RemoveLiquid(new Vector3(0f, -0.1f, 0f), 0.1f);
            yield return null;
            yield return null;
            Assert.That(simulation.Solver.ReadCountersNow().Removed, Is.GreaterThan(0));
        }

        [UnityTest]
        public IEnumerator ASaveGoesOnByItsPick()
        {
            costs.Set(FluidMethodKind.Standard, 1.0);
            simulation.FrameBudget = SoftBudget();
            Start();
            for (int i = 0; i < 3; i++) yield return null;
            FluidSolverSettings settings = simulation.Solver.Settings;
            var save = new MemoryStream();
            simulation.Save(save);
            ulong hash = simulation.ComputeStateHash();
            simulation.FrameBudget = 1000f;
            Start();
            Assert.That(simulation.MethodChoice.Pick.Offer.AsTheProfileAsks);
            save.Position = 0;
            Assert.That(simulation.Restore(save), simulation.StatusMessage);
            Assert.That(simulation.ComputeStateHash(), Is.EqualTo(hash));
            Assert.That(simulation.Solver.Settings.SoundSpeed, Is.EqualTo(settings.SoundSpeed).Within(1e-4f));
            Assert.That(simulation.MethodChoice.Reason, Does.Contain("as the save has it"));
            FluidSolver solver = simulation.Solver;
            for (int i = 0; i < 3; i++) yield return null;
            Assert.That(simulation.Solver, Is.SameAs(solver), "it is not chosen again");
            Assert.That(simulation.Solver.Settings.SoundSpeed, Is.EqualTo(settings.SoundSpeed).Within(5).Percent,
                "which follows the liquid");
        }

        [Test]
        public void ASaveOfAGivenMethodGoesOnByIt()
        {
            costs.Set(FluidMethodKind.Standard, 0.001);
            simulation.Method = FluidMethodKind.Thesis;
            Start();
            var save = new MemoryStream();
            simulation.Save(save);
            simulation.Method = FluidMethodKind.Automatic;
            Start();
            save.Position = 0;
            Assert.That(simulation.Restore(save), simulation.StatusMessage);
            Assert.That(simulation.ActiveMethod, Is.EqualTo(FluidMethodKind.Thesis));
        }

        [Test]
        public void ASaveOfAPickIsThatMethodsElsewhere()
        {
            costs.Set(FluidMethodKind.Standard, 0.001);
            Start();
            var save = new MemoryStream();
            simulation.Save(save);
            simulation.Method = FluidMethodKind.Standard;
            save.Position = 0;
            Assert.That(simulation.Restore(save), simulation.StatusMessage);
            Assert.That(simulation.MethodChoice, Is.Null);
        }

        [UnityTest]
        public IEnumerator ATightBudgetGoesToRobustAndALargerOneBack()
        {
            costs.Set(FluidMethodKind.Standard, 1.0).Set(FluidMethodKind.Robust, 0.1);
            Start();
            yield return null;
            FluidSolver solver = simulation.Solver;
            simulation.FrameBudget = 0.55f;
            yield return null;
            yield return null;
            Assert.That(simulation.Solver, Is.Not.SameAs(solver), "another method starts again");
            Assert.That(simulation.Solver.Kind, Is.EqualTo(FluidMethodKind.Robust));
            Assert.That(simulation.MethodChoice.Pick.Substeps, Is.EqualTo(5));
            Assert.That(simulation.Solver.Settings.Own<RobustSettings>().Substeps, Is.EqualTo(5));
            long steps = simulation.StepCount;
            yield return null;
            Assert.That(simulation.StepCount - steps, Is.EqualTo(5));
            solver = simulation.Solver;
            simulation.FrameBudget = 0.75f;
            yield return null;
            yield return null;
            Assert.That(simulation.Solver, Is.SameAs(solver), "other substeps of the same method act at once");
            Assert.That(simulation.Solver.Settings.Own<RobustSettings>().Substeps, Is.EqualTo(7));
            simulation.FrameBudget = 1000f;
            yield return null;
            yield return null;
            Assert.That(simulation.Solver.Kind, Is.EqualTo(FluidMethodKind.Standard));
        }

        [UnityTest]
        public IEnumerator OtherSettingsKeepTheMethodAndSayWhatANewStartWouldPick()
        {
            costs.Set(FluidMethodKind.Standard, 1.0).Set(FluidMethodKind.Robust, 0.1);
            simulation.FrameBudget = 4.5f; // 4 steps as the profile asks
            Start();
            yield return null;
            FluidSolver solver = simulation.Solver;
            simulation.ExpectedSpeed = 20f; // many more
            for (int i = 0; i < 4; i++) yield return null;
            Assert.That(simulation.Solver, Is.SameAs(solver));
            Assert.That(simulation.ActiveMethod, Is.EqualTo(FluidMethodKind.Standard));
            Assert.That(Choices().Length, Is.EqualTo(2), "said once");
            Assert.That(Choices().Last().Text, Does.Contain("another method than Standard, which stays in use").And.Contain("Robust"));
            Assert.That(simulation.CapHits, Is.Zero);
            Assert.That(simulation.ChooseMethodAgain());
            Assert.That(simulation.ActiveMethod, Is.EqualTo(FluidMethodKind.Robust));
        }

        [UnityTest]
        public IEnumerator ASaveOfRobustGoesOnByRobust()
        {
            costs.Set(FluidMethodKind.Standard, 1.0).Set(FluidMethodKind.Robust, 0.1);
            simulation.FrameBudget = 0.65f;
            Start();
            for (int i = 0; i < 3; i++) yield return null;
            var save = new MemoryStream();
            simulation.Save(save);
            simulation.FrameBudget = 1000f;
            Start();
            Assert.That(simulation.ActiveMethod, Is.EqualTo(FluidMethodKind.Standard));
            save.Position = 0;
            Assert.That(simulation.Restore(save), simulation.StatusMessage);
            for (int i = 0; i < 3; i++) yield return null;
            Assert.That(simulation.ActiveMethod, Is.EqualTo(FluidMethodKind.Robust));
            Assert.That(simulation.Solver.Settings.Own<RobustSettings>().Substeps, Is.EqualTo(6));
        }

        [Test]
        public void ADeviceWithoutStandardsKernelsRunsRobust()
        {
            costs.Set(FluidMethodKind.Standard, 1e-4).Set(FluidMethodKind.Robust, 1.0);
            FluidShaderSet without = TestShaders.Without(TestShaders.PackageSet, "StandardDensity");
            rig.Profile.Shaders = without;
            simulation.FrameBudget = 100f;
            Start();
            Assert.That(simulation.ActiveMethod, Is.EqualTo(FluidMethodKind.Robust));
            Assert.That(simulation.MethodChoice.Reason, Does.Contain("Standard has shaders that the shader set lacks"));
            UnityEngine.Object.DestroyImmediate(without);
        }

        [UnityTest]
        public IEnumerator WhatPlayMeasuresIsKept()
        {
            if (!StepTimer.IsSupported) Assert.Ignore("The device reports no GPU times.");
            costs.Set(FluidMethodKind.Standard, 1e-5, inPlay: false);
            simulation.SleepsAtRest = false;
            simulation.FrameBudget = 2e-4f;
            Start();
            Assert.That(simulation.MethodChoice.FitsBudget);
            for (int i = 0; i < 10 * StepTimer.Window && Choices().Length == 1; i++) yield return null;
            Assert.That(StepCosts.TryFind(StepCostKey.Create(simulation.Solver.Settings, false), 64, out StepCost cost));
            Assert.That(cost.InPlay);
            Assert.That(cost.Milliseconds, Is.GreaterThan(1e-4));
            Assert.That(Choices().Last().Text, Does.Contain("ms a frame in play, where"));
            Assert.That(simulation.MethodChoice.Pick.MillisecondsAStep, Is.EqualTo(1e-5).Within(1e-12), "said, not acted upon");
            Assert.That(simulation.Timer, Is.Null, "timing ends");
        }

        // Between what the profile's compression takes and what three times as much does, at 1 ms a step.
        private float SoftBudget()
        {
            FluidMethodCandidate[] ways = FluidSimulationChecks.PreviewChoice(simulation).Considered
                .Where(c => c.Method == FluidMethodKind.Standard).ToArray();
            return (float)(0.5 * (ways[0].StepsAFrame + ways[1].StepsAFrame));
        }

        private void SetAll(double milliseconds, bool inPlay = true)
        {
            foreach (FluidMethod method in FluidMethods.All) costs.Set(method.Kind, milliseconds, inPlay: inPlay);
        }

        private void Start() => Assert.That(simulation.StartSimulation(), simulation.StatusMessage);

        private FluidMessage[] Choices() => simulation.Messages.Where(m => m.Issue == FluidIssue.MethodChoice).ToArray();
    }
}
