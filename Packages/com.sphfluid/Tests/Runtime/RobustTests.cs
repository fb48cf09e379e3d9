using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Simulations by the Robust method in play: real time, emitters and drains, saves, messages.</summary>
    public sealed class RobustTests
    {
        private const float Frame = 1f / 64f;

        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig(Frame);

        [TearDown]
        public void TearDown() => rig.Dispose();

        private FluidSimulation Create(bool liquid = true)
        {
            FluidSimulation simulation = rig.Create(liquid: liquid);
            simulation.Method = FluidMethodKind.Robust;
            simulation.SleepsAtRest = false;
            return simulation;
        }

        // What each frame of the running liquid did.
        private static List<(double Frame, long Steps, double Time, float Step)> Follow(FluidSimulation simulation)
        {
            var frames = new List<(double, long, double, float)>();
            long steps = 0;
            double time = 0.0;
            simulation.Updated += s =>
            {
                frames.Add((Time.deltaTime, s.StepCount - steps, s.SimulatedTime - time, s.TimeStep));
                (steps, time) = (s.StepCount, s.SimulatedTime);
            };
            return frames;
        }

        [UnityTest]
        public IEnumerator FramesAreFourEqualStepsAndTheirTimeIsReal()
        {
            FluidSimulation simulation = Create();
            var frames = Follow(simulation);
            foreach (float frame in new[] { 1f / 64f, 1f / 64f, 1f / 128f, 1f / 32f, 1f / 61f, 1f / 61f })
            {
                Time.captureDeltaTime = frame;
                yield return null;
            }
            Assert.That(frames.Count, Is.GreaterThan(3));
            Assert.That(frames.Select(f => f.Frame).Distinct().Count(), Is.GreaterThan(2));
            foreach (var frame in frames)
            {
                Assert.That(frame.Steps, Is.EqualTo(4));
                Assert.That(frame.Time, Is.EqualTo(frame.Frame).Within(1e-6));
                Assert.That(frame.Step, Is.EqualTo(0.25 * frame.Frame).Within(1e-4).Percent);
            }
            Assert.That(simulation.RealTimeFactor, Is.EqualTo(1.0));
            Assert.That(simulation.Messages.Where(m => m.Severity != FluidSeverity.Info), Is.Empty);
        }

        [UnityTest]
        public IEnumerator SubstepsAndTheModeChangeWhileItRuns()
        {
            FluidSimulation simulation = Create();
            var frames = Follow(simulation);
            for (int i = 0; i < 3; i++) yield return null;
            rig.Profile.Substeps = 7;
            for (int i = 0; i < 2; i++) yield return null;
            Assert.That(frames.Last().Steps, Is.EqualTo(7));
            simulation.TimeStepMode = FluidTimeStepMode.Fixed;
            simulation.FixedTimeStep = Frame / 2f;
            for (int i = 0; i < 2; i++) yield return null;
            Assert.That(frames.Last().Steps, Is.EqualTo(2));
            Assert.That(simulation.TimeStep, Is.EqualTo(Frame / 2f));
        }

        [UnityTest]
        public IEnumerator WhatAHitchHasBeyondTheMostStepsIsDropped()
        {
            FluidSimulation simulation = Create();
            simulation.MaxSubstepsPerFrame = 8;
            var frames = Follow(simulation);
            for (int i = 0; i < 3; i++) yield return null;
            Time.captureDeltaTime = 0.125f; // as long as 15 of the longest steps
            for (int i = 0; i < 2; i++) yield return null;
            Assert.That(frames.Last().Steps, Is.EqualTo(8));
            Assert.That(frames.Last().Time, Is.EqualTo(8.0 / 120.0).Within(1e-5), "the rest is dropped");
            Assert.That(simulation.CapHits, Is.GreaterThan(0));
        }

        [UnityTest]
        public IEnumerator LiquidComesAndGoes()
        {
            FluidSimulation simulation = Create(false);
            GameObject holder = rig.NewObject("Nozzle");
            holder.transform.SetParent(simulation.transform, false);
            holder.transform.SetPositionAndRotation(new Vector3(0f, 0.15f, 0f), Quaternion.LookRotation(Vector3.down, Vector3.right));
            FluidEmitter emitter = holder.AddComponent<FluidEmitter>();
            emitter.Size = new Vector2(0.16f, 0.16f);
            emitter.Speed = 2f;
            for (int i = 0; i < 24; i++) yield return null;
            int poured = SimulationRig.Read(simulation).Length;
            Assert.That(poured, Is.GreaterThan(60));
            FluidParticle[] particles = SimulationRig.Read(simulation);
            Assert.That(particles.Select(p => p.Id), Is.Unique);
            Assert.That(particles.All(p => Mathf.Abs(p.Position.x) <= 0.2f && Mathf.Abs(p.Position.y) <= 0.2f && p.VelT0.magnitude < 8f));
            float[] pressures = GpuTest.Read<float>(simulation.Solver.Pressure, simulation.Solver.ParticleCount);
            Assert.That(pressures.All(p => p >= 0f && p < 1e6f), "those that are born have a pressure as well");
            emitter.enabled = false;
            simulation.RemoveLiquid(Vector3.zero, 2f * Vector3.one, Quaternion.identity);
            for (int i = 0; i < 4; i++) yield return null;
            Assert.That(SimulationRig.Read(simulation), Is.Empty);
            Assert.That(simulation.Solver.ReadCountersNow().NonFinite, Is.Zero);
        }

        [UnityTest]
        public IEnumerator ASaveGoesOnToTheBit()
        {
            FluidSimulation simulation = Create();
            for (int i = 0; i < 6; i++) yield return null;
            var stream = new MemoryStream();
            simulation.Save(stream);
            for (int i = 0; i < 8; i++) yield return null;
            ulong hash = simulation.ComputeStateHash();
            double time = simulation.SimulatedTime;
            stream.Position = 0;
            Assert.That(simulation.Restore(stream), Is.True, simulation.StatusMessage);
            for (int i = 0; i < 8; i++) yield return null;
            Assert.That(simulation.SimulatedTime, Is.EqualTo(time).Within(1e-9));
            Assert.That(simulation.ComputeStateHash(), Is.EqualTo(hash));
        }

        [UnityTest]
        public IEnumerator LiquidTooDeepForItsStepsIsNamed()
        {
            FluidSimulation simulation = Create(false);
            simulation.DomainSize = new Vector3(0.2f, 10f, 0.2f);
            rig.Profile.Substeps = 1;
            FluidVolume volume = rig.AddVolume(simulation);
            volume.Size = new Vector3(0.2f, 9f, 0.2f);
            FluidMessage found = simulation.Validate().FirstOrDefault(m => m.Issue == FluidIssue.TimeStepInvalid);
            Assert.That(found.Text, Does.Contain("sinks in under its own weight"));
            Assert.That(found.Cure, Does.Contain("Substeps"));
            yield return null;
        }
    }
}
