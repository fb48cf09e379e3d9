using System;
using System.Collections;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Liquid at rest takes no steps until something touches it.</summary>
    public sealed class SleepTests
    {
        private const int Most = 900;

        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig(0.02f);

        [TearDown]
        public void TearDown() => rig.Dispose();

        [UnityTest]
        public IEnumerator LiquidAtRestTakesNoStepsAndNoDispatches()
        {
            FluidSimulation simulation = Pool();
            yield return UntilAsleep(simulation);
            long steps = simulation.StepCount, dispatches = ComputeKernel.DispatchesRecorded;
            double time = simulation.SimulatedTime;
            FluidParticle[] rested = SimulationRig.Read(simulation);
            for (int frame = 0; frame < 20; frame++) yield return null;
            Assert.That(simulation.IsAsleep);
            Assert.That(simulation.StepCount, Is.EqualTo(steps));
            Assert.That(ComputeKernel.DispatchesRecorded, Is.EqualTo(dispatches));
            Assert.That(simulation.SimulatedTime - time, Is.EqualTo(0.4).Within(1e-6), "time goes on");
            Assert.That(simulation.RealTimeFactor, Is.EqualTo(1.0).Within(1e-6));
            Assert.That(SimulationRig.Read(simulation), Is.EqualTo(rested));

            simulation.Wake();
            Assert.That(simulation.IsAsleep, Is.False);
            yield return null;
            Assert.That(simulation.StepCount - steps, Is.InRange(1, 40), "a frame's steps, and none for the time asleep");
            Assert.That(simulation.SimulatedTime - time, Is.EqualTo(0.42).Within(0.005));
            Assert.That(simulation.CapHits, Is.Zero);
            yield return UntilAsleep(simulation);
        }

        [UnityTest]
        public IEnumerator APoolThatStartsInItsBalanceSleepsWithinFiveSeconds()
        {
            FluidSimulation simulation = Pool();
            simulation.DomainSize = new Vector3(0.3f, 0.3f, 0.18f);
            simulation.Spacing = 0.03f; // 10 x 6 x 6 particles: some of them find a better place
            FluidVolume volume = simulation.GetComponentInChildren<FluidVolume>();
            volume.Size = new Vector3(0.3f, 0.18f, 0.18f);
            volume.transform.localPosition = new Vector3(0f, -0.06f, 0f);
            yield return UntilAsleep(simulation);
            Assert.That(simulation.SimulatedTime, Is.LessThan(5.0));
        }

        [UnityTest]
        public IEnumerator WhateverTouchesTheLiquidWakesItInTheSameFrame()
        {
            FluidSimulation simulation = Pool();
            GameObject box = rig.NewObject("Box");
            box.AddComponent<BoxCollider>().size = new Vector3(0.05f, 0.05f, 0.05f);
            box.transform.position = new Vector3(0.06f, 0.1f, 0f);
            yield return UntilAsleep(simulation);
            foreach ((string what, Action touch) in Touches(simulation, box))
            {
                long steps = simulation.StepCount;
                touch();
                yield return null;
                Assert.That(simulation.IsAsleep, Is.False, what);
                Assert.That(simulation.StepCount, Is.GreaterThan(steps), what);
                yield return UntilAsleep(simulation);
            }
        }

        [UnityTest]
        public IEnumerator WhatIsOutsideTheDomainWakesNothing()
        {
            FluidSimulation simulation = Pool();
            GameObject box = rig.NewObject("Far");
            box.AddComponent<BoxCollider>();
            box.transform.position = new Vector3(20f, 0f, 0f);
            yield return UntilAsleep(simulation);
            box.transform.position = new Vector3(30f, 0f, 0f);
            for (int frame = 0; frame < 3; frame++) yield return null;
            Assert.That(simulation.IsAsleep);
        }

        [UnityTest]
        public IEnumerator SloshingLiquidAndLiquidThatMayNotDoNotSleep()
        {
            FluidSimulation sloshing = Pool("Sloshing");
            sloshing.VelocityField = position => new Vector3(0.25f * Mathf.Cos(Mathf.PI * position.x / 0.2f), 0f, 0f);
            FluidSimulation never = Pool("Never", new Vector3(0f, 5f, 0f));
            never.SleepsAtRest = false;
            for (int frame = 0; frame < 75; frame++)
            {
                yield return null;
                Assert.That(sloshing.IsAsleep, Is.False);
            }
            yield return UntilAsleep(sloshing);
            for (int frame = 0; frame < 75; frame++)
            {
                yield return null;
                Assert.That(never.IsAsleep, Is.False);
            }
            never.SleepsAtRest = true;
            yield return UntilAsleep(never);
            never.SleepsAtRest = false;
            yield return null;
            Assert.That(never.IsAsleep, Is.False);
        }

        [UnityTest]
        public IEnumerator TheSameLiquidSleepsInTheSameFrameAndPlace()
        {
            var frames = new int[2];
            var ends = new FluidParticle[2][];
            for (int turn = 0; turn < 2; turn++)
            {
                FluidSimulation simulation = Pool();
                yield return null;
                simulation.StartSimulation();
                for (; !simulation.IsAsleep && frames[turn] < Most; frames[turn]++)
                {
                    yield return null;
                    if (turn == 1) UnityEngine.Rendering.AsyncGPUReadback.WaitAllRequests();
                }
                ends[turn] = SimulationRig.Read(simulation);
                UnityEngine.Object.DestroyImmediate(simulation.gameObject);
            }
            Assert.That(frames[0], Is.LessThan(Most).And.EqualTo(frames[1]));
            Assert.That(ends[1].Select(p => p.Position), Is.EqualTo(ends[0].Select(p => p.Position)), "to the last bit");
        }

        private static (string, Action)[] Touches(FluidSimulation simulation, GameObject box) => new (string, Action)[]
        {
            ("a collider moves", () => box.transform.position -= new Vector3(0.02f, 0f, 0f)),
            ("a collider goes", () => box.SetActive(false)),
            ("a collider comes", () => box.SetActive(true)),
            ("gravity changes", () =>
            {
                simulation.UseSceneGravity = false;
                simulation.Gravity = new Vector3(0f, -9f, 0f);
            }),
            ("the domain turns", () => simulation.transform.rotation = Quaternion.Euler(0f, 0f, 1f)),
            ("the domain moves", () => simulation.transform.position += new Vector3(0.01f, 0f, 0f)),
            ("the profile changes", () => simulation.Profile.KinematicViscosity = 2e-6f),
            ("a script gives particles", () => simulation.Solver.SetParticles(SimulationRig.Read(simulation))),
            ("a script wakes it", simulation.Wake),
        };

        // 0.2 m wide and 0.12 m deep, 75 particles.
        // As beside the cup of the sample Pour and Fill.
        [UnityTest]
        public IEnumerator ADropThatSlidesOverTheFloorKeepsLiquidAwakeUntilFrictionHoldsIt()
        {
            FluidSimulation simulation = Pool();
            simulation.DomainSize = new Vector3(0.6f, 0.3f, 0.2f);
            simulation.GetComponentInChildren<FluidVolume>().transform.localPosition = new Vector3(-0.2f, -0.09f, 0f);
            GameObject wall = rig.NewObject("Wall");
            wall.AddComponent<BoxCollider>().size = new Vector3(0.1f, 0.4f, 0.3f);
            wall.transform.position = new Vector3(-0.05f, 0f, 0f);
            FluidVolume drop = rig.AddVolume(simulation, "Drop");
            drop.Size = simulation.Spacing * Vector3.one;
            drop.transform.localPosition = new Vector3(0.16f, -0.13f, 0f);
            simulation.VelocityField = position => position.x > 0f ? new Vector3(0.04f, 0f, 0.02f) : Vector3.zero;
            while (simulation.SimulatedTime < 6.0)
            {
                yield return null;
                Assert.That(simulation.IsAsleep, Is.False);
            }
            simulation.Boundaries = new FluidBoundaries { Friction = 1f };
            yield return UntilAsleep(simulation);
        }

        private FluidSimulation Pool(string name = "Pool", Vector3 position = default)
        {
            FluidSimulation simulation = rig.Create(name, false, position);
            simulation.DomainSize = new Vector3(0.2f, 0.3f, 0.2f);
            simulation.Spacing = 0.04f;
            simulation.StartRelaxation = FluidStartRelaxation.Hydrostatic;
            FluidVolume volume = rig.AddVolume(simulation);
            volume.Size = new Vector3(0.2f, 0.12f, 0.2f);
            volume.transform.localPosition = new Vector3(0f, -0.09f, 0f);
            return simulation;
        }

        private static IEnumerator UntilAsleep(FluidSimulation simulation)
        {
            for (int frame = 0; frame < Most && !simulation.IsAsleep; frame++) yield return null;
            Assert.That(simulation.IsAsleep, $"after {simulation.SimulatedTime} s");
        }
    }
}
