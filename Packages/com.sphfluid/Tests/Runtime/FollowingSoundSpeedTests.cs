using System;
using System.Collections;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>
    /// The speed of sound that follows the liquid: down once it has come down, up when it is lifted, never above the rule.
    /// </summary>
    public sealed class FollowingSoundSpeedTests
    {
        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig(0.02f);

        [TearDown]
        public void TearDown() => rig.Dispose();

        [UnityTest]
        public IEnumerator LiquidThatHasComeDownTakesFewerSteps()
        {
            FluidSimulation following = Falling("Following"), byRule = Falling("By Rule", new Vector3(0f, 5f, 0f));
            FluidProfile other = Object.Instantiate(rig.Profile);
            other.SoundSpeedMode = FluidSoundSpeedMode.FixedByRule;
            byRule.Profile = other;
            yield return null;
            yield return null;
            float rule = following.Solver.Settings.SoundSpeed;
            Assert.That(rule, Is.EqualTo(5f * Mathf.Sqrt(2f * 9.81f * 0.4f)).Within(0.01f));
            long early = following.StepCount, earlyByRule = byRule.StepCount;
            for (int frame = 0; frame < 150; frame++)
            {
                yield return null;
                FluidSolverSettings now = following.Solver.Settings;
                Assert.That(now.SoundSpeed, Is.LessThanOrEqualTo(rule * 1.0001f));
                Assert.That(now.SoundSpeed, Is.GreaterThanOrEqualTo(Mathf.Sqrt(9.81f * 0.05f / 0.04f)), "Max Compression holds");
                Assert.That(following.TimeStep, Is.LessThanOrEqualTo(0.7501f * (float)FluidRules.Advise(now, 0.0).Acoustic));
                float viscosity = now.Viscosity / now.RestDensity;
                Assert.That(viscosity, Is.EqualTo(0.001f * now.SoundSpeed * now.SupportRadius).Within(1e-7f), "α c R");
            }
            long steps = following.StepCount, stepsByRule = byRule.StepCount;
            for (int frame = 0; frame < 10; frame++) yield return null;
            Assert.That(byRule.Solver.Settings.SoundSpeed, Is.EqualTo(rule).Within(1e-4f), "the same but for the height of its place");
            Assert.That(following.Solver.Settings.SoundSpeed, Is.LessThan(0.65f * rule));
            Assert.That(following.StepCount - steps, Is.LessThan(0.7 * (byRule.StepCount - stepsByRule)));
            Assert.That(following.SimulatedTime, Is.EqualTo(byRule.SimulatedTime).Within(0.005), "up to a step waits");
            Assert.That(earlyByRule, Is.GreaterThanOrEqualTo(early));
            byRule.enabled = false;
            Object.DestroyImmediate(other);
        }

        [UnityTest]
        public IEnumerator CalmLiquidIsAsStiffAsTheStepsOfAFrameAllow()
        {
            FluidSimulation simulation = Falling("Calm");
            simulation.SleepsAtRest = false;
            for (int frame = 0; frame < 250; frame++) yield return null;
            FluidSolverSettings now = simulation.Solver.Settings;
            double needed = Math.Sqrt(9.81 * 0.05 / 0.04), advised = 0.75 * FluidRules.Advise(now, 0.0).Acoustic;
            double steps = Math.Round(0.02 / simulation.TimeStep);
            Assert.That(steps * simulation.TimeStep, Is.EqualTo(0.02).Within(1e-6));
            Assert.That(advised, Is.InRange(simulation.TimeStep, 1.25 * simulation.TimeStep), "the clock's margin, and what moves");
            Assert.That(now.SoundSpeed, Is.GreaterThan(1.3 * needed), "Max Compression would do with so much");
        }

        [UnityTest]
        public IEnumerator LiquidThatIsLiftedGetsItsSpeedOfSoundBackBeforeItFalls()
        {
            FluidSimulation simulation = Falling("Lifted");
            simulation.SleepsAtRest = false;
            yield return null;
            yield return null;
            float rule = simulation.Solver.Settings.SoundSpeed;
            for (int frame = 0; frame < 150; frame++) yield return null;
            float calm = simulation.Solver.Settings.SoundSpeed;
            simulation.UseSceneGravity = false;
            simulation.Gravity = new Vector3(0f, 9.81f, 0f); // all of it falls to the top
            float largest = 0f;
            for (int frame = 0; frame < 25; frame++)
            {
                yield return null;
                largest = Mathf.Max(largest, simulation.Solver.Settings.SoundSpeed);
            }
            Assert.That(calm, Is.LessThan(0.65f * rule));
            Assert.That(largest, Is.GreaterThan(0.9f * rule));
        }

        [UnityTest]
        public IEnumerator ParticlesFromAScriptAreMetByTheRule()
        {
            FluidSimulation simulation = Falling("Again");
            simulation.SleepsAtRest = false;
            yield return null;
            yield return null;
            FluidParticle[] start = SimulationRig.Read(simulation);
            float rule = simulation.Solver.Settings.SoundSpeed;
            for (int frame = 0; frame < 100; frame++) yield return null;
            Assert.That(simulation.Solver.Settings.SoundSpeed, Is.LessThan(0.8f * rule));
            simulation.Solver.SetParticles(start);
            yield return null;
            Assert.That(simulation.Solver.Settings.SoundSpeed, Is.EqualTo(rule).Within(1e-3f));
        }

        [UnityTest]
        public IEnumerator AColliderThatMovesFastRaisesIt()
        {
            FluidSimulation simulation = Falling("Stirred");
            GameObject paddle = rig.NewObject("Paddle");
            paddle.AddComponent<BoxCollider>().size = new Vector3(0.02f, 0.1f, 0.1f);
            paddle.transform.position = new Vector3(-0.1f, 0.1f, 0f);
            yield return null;
            yield return null;
            float rule = simulation.Solver.Settings.SoundSpeed;
            for (int frame = 0; frame < 150; frame++) yield return null;
            float calm = simulation.Solver.Settings.SoundSpeed;
            for (int frame = 0; frame < 5; frame++)
            {
                paddle.transform.position += new Vector3(0.05f, 0f, 0f); // 2.5 m/s, in the air
                yield return null;
            }
            Assert.That(calm, Is.LessThan(0.65f * rule));
            Assert.That(simulation.Solver.Settings.SoundSpeed, Is.InRange(1.4f * calm, 5f * 4f),
                "made for its speed and the jolt, whatever the rule");
        }

        [UnityTest]
        public IEnumerator SettingsThatAScriptGivesStay()
        {
            FluidSimulation simulation = Falling("Script");
            yield return null;
            yield return null;
            simulation.Solver.ApplySettings(simulation.Solver.Settings.WithSoundSpeed(33f));
            for (int frame = 0; frame < 30; frame++) yield return null;
            Assert.That(simulation.Solver.Settings.SoundSpeed, Is.EqualTo(33f));
            Assert.That(simulation.TimeStep,
                Is.LessThanOrEqualTo(0.7501f * (float)FluidRules.Advise(simulation.Solver.Settings, 0.0).Acoustic));
            rig.Profile.RestDensity = 900f;
            yield return null;
            Assert.That(simulation.Solver.Settings.SoundSpeed, Is.LessThan(33f));
        }

        [UnityTest]
        public IEnumerator OtherMethodsAndFixedStepsKeepTheRule()
        {
            FluidSimulation thesis = Falling("Thesis"), stepped = Falling("Fixed", new Vector3(0f, 5f, 0f));
            thesis.Method = FluidMethodKind.Thesis;
            stepped.TimeStepMode = FluidTimeStepMode.Fixed;
            yield return null;
            yield return null;
            float ofThesis = thesis.Solver.Settings.SoundSpeed, ofStepped = stepped.Solver.Settings.SoundSpeed;
            for (int frame = 0; frame < 60; frame++) yield return null;
            Assert.That(thesis.Solver.Settings.SoundSpeed, Is.EqualTo(ofThesis));
            Assert.That(stepped.Solver.Settings.SoundSpeed, Is.EqualTo(ofStepped));
            Assert.That(stepped.TimeStep, Is.EqualTo(stepped.FixedTimeStep));
        }

        [UnityTest]
        public IEnumerator TheModeChangesDuringPlay()
        {
            FluidSimulation simulation = Falling("Changing");
            yield return null;
            yield return null;
            float rule = simulation.Solver.Settings.SoundSpeed;
            for (int frame = 0; frame < 100; frame++) yield return null;
            FluidSolver solver = simulation.Solver;
            rig.Profile.SoundSpeedMode = FluidSoundSpeedMode.FixedByRule;
            yield return null;
            Assert.That(simulation.Solver, Is.SameAs(solver));
            Assert.That(solver.Settings.SoundSpeed, Is.EqualTo(rule));
            Assert.That(simulation.TimeStep, Is.EqualTo(solver.Settings.TimeStep));
        }

        [UnityTest]
        public IEnumerator ResultsDoNotDependOnWhenTheReadBacksArrive()
        {
            var ends = new FluidParticle[2][];
            var steps = new long[2];
            for (int turn = 0; turn < 2; turn++)
            {
                FluidSimulation simulation = Falling("Turn");
                yield return null;
                simulation.StartSimulation();
                for (int frame = 0; frame < 60; frame++)
                {
                    yield return null;
                    if (turn == 1) AsyncGPUReadback.WaitAllRequests();
                }
                ends[turn] = SimulationRig.Read(simulation);
                steps[turn] = simulation.StepCount;
                Object.DestroyImmediate(simulation.gameObject);
            }
            Assert.That(steps[1], Is.EqualTo(steps[0]));
            Assert.That(ends[1].Select(p => p.Position), Is.EqualTo(ends[0].Select(p => p.Position)), "to the last bit");
        }

        // 0.05 m deep at rest, from the upper half of a box 0.4 m high.
        private FluidSimulation Falling(string name, Vector3 position = default)
        {
            FluidSimulation simulation = rig.Create(name, false, position);
            FluidVolume volume = rig.AddVolume(simulation);
            volume.Size = new Vector3(0.2f, 0.2f, 0.2f);
            volume.transform.localPosition = new Vector3(-0.1f, 0.1f, -0.1f);
            return simulation;
        }
    }
}
