using System.Collections;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Pause, single steps and the time scale of a liquid; colliders that move meanwhile, or that several liquids share.</summary>
    public sealed class ControlTests
    {
        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig();

        [TearDown]
        public void TearDown()
        {
            Time.timeScale = 1f;
            rig.Dispose();
        }

        [UnityTest]
        public IEnumerator StillLiquidRecordsNothingAndGoesOnToTheBitAsWithoutThePause([Values("paused", "scene", "scale")] string how)
        {
            var ends = new FluidParticle[2][];
            var counts = new long[2];
            for (int turn = 0; turn < 2; turn++)
            {
                FluidSimulation simulation = rig.Create();
                yield return null;
                simulation.StartSimulation();
                for (int frame = 0; frame < 8; frame++) yield return null;
                if (turn == 1)
                {
                    Still(simulation, how, true);
                    yield return null;
                    long steps = simulation.StepCount, dispatches = ComputeKernel.DispatchesRecorded;
                    double time = simulation.SimulatedTime;
                    FluidParticle[] before = SimulationRig.Read(simulation);
                    for (int frame = 0; frame < 5; frame++) yield return null;
                    Assert.That(simulation.IsRunning);
                    Assert.That(simulation.StepCount, Is.EqualTo(steps).And.GreaterThan(0));
                    Assert.That(simulation.SimulatedTime, Is.EqualTo(time));
                    Assert.That(ComputeKernel.DispatchesRecorded, Is.EqualTo(dispatches));
                    Assert.That(SimulationRig.Read(simulation), Is.EqualTo(before));
                    Still(simulation, how, false);
                }
                for (int frame = 0; frame < 8; frame++) yield return null;
                ends[turn] = SimulationRig.Read(simulation);
                counts[turn] = simulation.StepCount;
                Object.DestroyImmediate(simulation.gameObject);
            }
            Assert.That(counts[1], Is.EqualTo(counts[0]));
            Assert.That(ends[1], Is.EqualTo(ends[0]), "to the last bit");
        }

        [UnityTest]
        public IEnumerator StepOnceTakesAsManyStepsAsItWasCalledWhateverTheTime([Values] FluidTimeStepMode mode)
        {
            FluidSimulation simulation = rig.Create();
            simulation.TimeStepMode = mode;
            for (int frame = 0; frame < 4; frame++) yield return null;
            Time.timeScale = 0f;
            for (int calls = 1; calls <= 3; calls++)
            {
                long steps = simulation.StepCount;
                double time = simulation.SimulatedTime;
                for (int call = 0; call < calls; call++) simulation.StepOnce();
                yield return null;
                Assert.That(simulation.Paused);
                Assert.That(simulation.StepCount - steps, Is.EqualTo(calls));
                Assert.That(simulation.SimulatedTime - time, Is.EqualTo(calls * simulation.TimeStep).Within(2).Percent);
                yield return null;
                Assert.That(simulation.StepCount - steps, Is.EqualTo(calls), "no step of its own");
            }
            Time.timeScale = 1f;
            yield return null; // a frame's time is set before its scripts run
            simulation.StepOnce();
            simulation.Paused = false;
            long last = simulation.StepCount;
            yield return null;
            Assert.That(simulation.StepCount, Is.GreaterThan(last));
            Assert.That(simulation.Messages, Is.Empty);
        }

        [UnityTest]
        public IEnumerator StepOnceOfStoppedLiquidIsNoStepAfterTheStart()
        {
            FluidSimulation simulation = rig.Create();
            simulation.PlayOnEnable = true;
            simulation.StepOnce();
            for (int frame = 0; frame < 4; frame++) yield return null;
            Assert.That(simulation.IsRunning);
            Assert.That(simulation.StepCount, Is.Zero);
        }

        [UnityTest]
        public IEnumerator TimeScaleIsTheLiquidsTimeOverTheScenes()
        {
            FluidSimulation plain = rig.Create("Plain"), half = rig.Create("Half", position: new Vector3(2f, 0f, 0f)),
                twice = rig.Create("Twice", position: new Vector3(4f, 0f, 0f));
            half.TimeScale = 0.5f;
            twice.TimeScale = 2f;
            for (int frame = 0; frame < 25; frame++) yield return null;
            Assert.That(plain.SimulatedTime, Is.EqualTo(0.24).Within(0.02));
            Assert.That(half.SimulatedTime / plain.SimulatedTime, Is.EqualTo(0.5).Within(0.03));
            Assert.That(twice.SimulatedTime / plain.SimulatedTime, Is.EqualTo(2.0).Within(0.06));
        }

        [UnityTest]
        public IEnumerator ATimeScaleThatCannotBeIsReportedOnceAndTheLiquidStandsStill(
            [Values(-1f, float.NaN, float.PositiveInfinity)] float scale)
        {
            FluidSimulation simulation = rig.Create();
            for (int frame = 0; frame < 3; frame++) yield return null;
            LogAssert.Expect(LogType.Error, new Regex("'Fluid'.*Time Scale is .*stands still.*Set Time Scale to 0 or more"));
            simulation.TimeScale = scale;
            long steps = simulation.StepCount;
            for (int frame = 0; frame < 3; frame++) yield return null;
            Assert.That(simulation.IsRunning);
            Assert.That(simulation.StepCount, Is.EqualTo(steps));
            Assert.That(simulation.Messages.Single().Issue, Is.EqualTo(FluidIssue.TimeScaleInvalid));
            simulation.TimeScale = 1f;
            yield return null;
            Assert.That(simulation.StepCount, Is.GreaterThan(steps));
        }

        [UnityTest]
        public IEnumerator ACollidersMotionDuringThePauseIsGoneThroughAfterIt([Values("paused", "scene")] string how, [Values] bool single)
        {
            FluidSimulation simulation = rig.Create();
            simulation.ExpectedSpeed = 10f;
            Transform plate = Plate(0.6f);
            for (int frame = 0; frame < 3; frame++) yield return null;
            Still(simulation, how, true);
            for (int frame = 1; frame <= 5; frame++)
            {
                plate.position = new Vector3(-0.15f + 0.02f * frame, 0f, 0f);
                yield return null;
            }
            Assert.That(SimulationRig.Read(simulation).Any(p => p.Position.x < plate.position.x),
                "the plate is in the liquid, which stands still");
            if (single) simulation.StepOnce();
            else Still(simulation, how, false);
            for (int frame = 0; frame < 2; frame++) yield return null;
            AssertIsAhead(simulation, plate);
            Assert.That(simulation.Messages.Any(m => m.Issue == FluidIssue.ColliderJumped), Is.False);
        }

        [UnityTest]
        public IEnumerator LiquidsThatShareAMovingColliderBothStayAheadOfIt()
        {
            FluidSimulation near = rig.Create("Near"), far = rig.Create("Far", position: new Vector3(0f, 0f, 1f));
            far.Method = near.Method = FluidMethodKind.Standard;
            Transform plate = Plate(3f);
            for (int frame = 0; frame < 3; frame++) yield return null;
            for (int frame = 1; frame <= 20; frame++)
            {
                plate.position = new Vector3(-0.15f + 0.008f * frame, 0f, 0f);
                yield return null;
                AssertIsAhead(near, plate);
                AssertIsAhead(far, plate);
            }
            Assert.That(near.Messages.Concat(far.Messages).Any(m => m.Issue == FluidIssue.ColliderJumped), Is.False);
        }

        private static void Still(FluidSimulation simulation, string how, bool still)
        {
            if (how == "paused") simulation.Paused = still;
            else if (how == "scene") Time.timeScale = still ? 0f : 1f;
            else simulation.TimeScale = still ? 0f : 1f;
        }

        // To the left of the liquid, over the whole height of the domain.
        private Transform Plate(float width)
        {
            GameObject plate = rig.NewObject("Plate");
            plate.AddComponent<BoxCollider>().size = new Vector3(0.02f, 0.6f, width);
            plate.transform.position = new Vector3(-0.15f, 0f, 0f);
            return plate.transform;
        }

        private static void AssertIsAhead(FluidSimulation simulation, Transform plate)
        {
            FluidParticle[] particles = SimulationRig.Read(simulation);
            Assert.That(particles.Length, Is.EqualTo(64));
            Assert.That(particles.Min(p => p.Position.x), Is.GreaterThan(plate.position.x), simulation.name);
        }
    }
}
