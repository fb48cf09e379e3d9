using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Profiling;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>A simulation made from code starts, steps, stops, comes back and leaves nothing behind.</summary>
    public sealed class LifecycleTests
    {
        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig();

        [TearDown]
        public void TearDown() => rig.Dispose();

        [UnityTest]
        public IEnumerator AddComponentFromCodeNeedsOnlyAProfile()
        {
            FluidSimulation simulation = rig.Create();
            Assert.That(simulation.IsRunning, Is.False, "it starts with the first LateUpdate, after the code that made it");
            yield return null;
            yield return null;
            Assert.That(simulation.IsRunning, simulation.StatusMessage);
            Assert.That(simulation.ParticleCount, Is.EqualTo(64));
            Assert.That(simulation.Messages, Is.Empty);
        }

        [UnityTest]
        public IEnumerator TimeAndLiquidMoveWithTheFrames()
        {
            FluidSimulation simulation = rig.Create();
            rig.Profile.SoundSpeedMode = FluidSoundSpeedMode.FixedByRule;
            yield return Until(simulation);
            float height = SimulationRig.MeanHeight(simulation);
            double before = simulation.SimulatedTime;
            for (int frame = 0; frame < 10; frame++) yield return null;
            Assert.That(simulation.SimulatedTime - before, Is.EqualTo(0.1).Within(0.011));
            Assert.That(simulation.StepCount * (double)simulation.TimeStep, Is.EqualTo(simulation.SimulatedTime).Within(1e-5));
            Assert.That(SimulationRig.MeanHeight(simulation) - height, Is.EqualTo(-0.5 * 9.81 * 0.01).Within(0.015), "0.1 s of fall");
        }

        [UnityTest]
        public IEnumerator BuffersAreGivenEachFrameWhileTheLiquidRuns()
        {
            FluidSimulation simulation = rig.Create(position: new Vector3(1f, 2f, 3f));
            var steps = new List<long>();
            bool given = true;
            simulation.Updated += s =>
            {
                given &= s.TryGetBuffers(out FluidBuffers now) && now.IsValid && now.Particles.count >= now.ParticleCount;
                steps.Add(s.StepCount);
            };
            Assert.That(simulation.TryGetBuffers(out FluidBuffers none), Is.False);
            Assert.That(none.IsValid, Is.False);
            yield return Until(simulation);
            steps.Clear();
            yield return null;
            yield return null;
            simulation.Paused = true;
            yield return null;
            Assert.That(given);
            Assert.That(steps.Count, Is.EqualTo(3), "paused too");
            Assert.That(steps[1], Is.GreaterThan(steps[0]), "after the steps");
            Assert.That(steps[2], Is.EqualTo(steps[1]));
            Assert.That(simulation.TryGetBuffers(out FluidBuffers buffers));
            Assert.That(buffers.ParticleCount, Is.EqualTo(64));
            Assert.That(buffers.LocalToWorld.MultiplyPoint3x4(Vector3.zero), Is.EqualTo(new Vector3(1f, 2f, 3f)));
            simulation.StopSimulation();
            Assert.That(buffers.IsValid, Is.False);
            yield return null;
            Assert.That(steps.Count, Is.EqualTo(3), "not while stopped");
        }

        [UnityTest]
        public IEnumerator TheStartIsShownBeforeTheFirstStep()
        {
            FluidSimulation simulation = rig.Create();
            int startFrame = -1, stepFrame = -1;
            for (int frame = 0; frame < 5 && stepFrame < 0; frame++)
            {
                yield return null;
                if (startFrame < 0 && simulation.IsRunning) startFrame = frame;
                if (simulation.StepCount > 0) stepFrame = frame;
            }
            Assert.That(stepFrame, Is.EqualTo(startFrame + 1));
        }

        [UnityTest]
        public IEnumerator DisableFreesEnableStartsAgain()
        {
            FluidSimulation simulation = rig.Create();
            yield return Until(simulation);
            GraphicsBuffer particles = simulation.Solver.Particles;
            FluidParticle[] start = SimulationRig.Read(simulation);
            yield return null;
            yield return null;
            particles = simulation.Solver.Particles;
            int stopped = 0;
            simulation.Stopped += _ => stopped++;

            simulation.enabled = false;
            Assert.That(simulation.IsRunning, Is.False);
            Assert.That(simulation.Solver, Is.Null);
            Assert.That(simulation.GpuBytes, Is.Zero);
            Assert.That(particles.IsValid(), Is.False, "the GPU memory is gone at once");
            Assert.That(FluidSimulation.Active, Has.No.Member(simulation));
            Assert.That(stopped, Is.EqualTo(1));
            yield return null;

            simulation.enabled = true;
            yield return Until(simulation);
            Assert.That(FluidSimulation.Active, Has.Member(simulation));
            Assert.That(SimulationRig.Read(simulation).Select(p => p.Position), Is.EqualTo(start.Select(p => p.Position)),
                "the same start again");
        }

        [UnityTest]
        public IEnumerator TwoHundredCyclesWithAllThatActsReturnTheGpuMemory()
        {
            FluidSimulation simulation = rig.Create();
            foreach (System.Type part in new[] { typeof(FluidEmitter), typeof(FluidDrain), typeof(FluidForceZone), typeof(FluidSensor),
                typeof(BoxCollider) })
            {
                GameObject holder = rig.NewObject(part.Name);
                holder.transform.SetParent(simulation.transform, false);
                holder.transform.localPosition = new Vector3(0.1f, 0.15f, 0.1f);
                holder.transform.localScale = 0.1f * Vector3.one;
                holder.AddComponent(part);
            }
            simulation.GetComponentInChildren<BoxCollider>().transform.localPosition = new Vector3(-0.15f, -0.15f, 0f);
            long first = 0, running = 0, queries = 0, most = 0;
            for (int cycle = 0; cycle < 200; cycle++)
            {
                yield return Until(simulation);
                yield return null;
                simulation.CapacityPolicy = (FluidCapacityPolicy)(cycle % 3);
                simulation.Capacity = cycle % 3 == 0 ? 0 : 70 + cycle % 7;
                simulation.AddImpulse(Vector3.zero, 0.1f, 0.1f * Vector3.up);
                running = System.Math.Max(running, simulation.GpuBytes);
                queries = System.Math.Max(queries, simulation.Queries.GpuBytes);
                most = System.Math.Max(most, Profiler.GetAllocatedMemoryForGraphicsDriver());
                yield return null;
                simulation.enabled = false;
                Assert.That(simulation.GpuBytes, Is.Zero);
                yield return null;
                if (cycle == 9) first = Profiler.GetAllocatedMemoryForGraphicsDriver();
                simulation.enabled = true;
            }
            simulation.enabled = false;
            yield return null;
            yield return null;
            Assert.That(queries, Is.Positive, "the sensor asked");
            Assert.That(running, Is.GreaterThan(queries));
            Assert.That(most, Is.GreaterThan(first), "what is measured counts buffers");
            Assert.That(Profiler.GetAllocatedMemoryForGraphicsDriver() - first, Is.LessThan(2 * running),
                "190 cycles that kept a hundredth of their memory would show");
        }

        [UnityTest]
        public IEnumerator DestroyFreesAndAnotherCanBeMade()
        {
            FluidSimulation first = rig.Create("First");
            yield return Until(first);
            GraphicsBuffer particles = first.Solver.Particles;
            Object.DestroyImmediate(first.gameObject);
            Assert.That(particles.IsValid(), Is.False);
            FluidSimulation second = rig.Create("Second");
            yield return Until(second);
            Assert.That(second.ParticleCount, Is.EqualTo(64));
        }

        [UnityTest]
        public IEnumerator StopStartAndReset()
        {
            FluidSimulation simulation = rig.Create();
            simulation.PlayOnEnable = false;
            simulation.enabled = false;
            simulation.enabled = true;
            yield return null;
            yield return null;
            Assert.That(simulation.IsRunning, Is.False);

            int started = 0;
            simulation.Started += _ => started++;
            Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
            FluidParticle[] start = SimulationRig.Read(simulation);
            yield return null;
            yield return null;
            Assert.That(simulation.StepCount, Is.Positive);
            Assert.That(simulation.ResetSimulation());
            Assert.That(simulation.StepCount, Is.Zero);
            Assert.That(SimulationRig.Read(simulation).Select(p => p.Position), Is.EqualTo(start.Select(p => p.Position)));
            Assert.That(started, Is.EqualTo(2));

            simulation.StopSimulation();
            yield return null;
            Assert.That(simulation.IsRunning, Is.False);
            Assert.That(simulation.TryReadParticles(new System.Collections.Generic.List<FluidParticle>()), Is.False);
        }

        [UnityTest]
        public IEnumerator TwoSimulationsDoNotDisturbEachOther()
        {
            yield return null; // frames of the rig's length from here on
            FluidSimulation alone = rig.Create("Alone");
            alone.PlayOnEnable = false;
            alone.StopSimulation();
            alone.StartSimulation();
            for (int frame = 0; frame < 6; frame++) yield return null;
            FluidParticle[] expected = SimulationRig.Read(alone);
            long steps = alone.StepCount;
            Object.DestroyImmediate(alone.gameObject);

            FluidSimulation first = rig.Create("First");
            FluidSimulation second = rig.Create("Second", position: new Vector3(5f, 0f, 0f));
            second.Spacing = 0.04f;
            first.StartSimulation();
            second.StartSimulation();
            Assert.That(FluidSimulation.Active, Is.SupersetOf(new[] { first, second }));
            for (int frame = 0; frame < 6; frame++) yield return null;
            Assert.That(first.StepCount, Is.EqualTo(steps));
            Assert.That(SimulationRig.Read(first).Select(p => p.Position), Is.EqualTo(expected.Select(p => p.Position)), "to the last bit");
            Assert.That(second.ParticleCount, Is.EqualTo(125));
            Assert.That(SimulationRig.MeanHeight(second), Is.LessThan(-0.005f));
        }

        [UnityTest]
        public IEnumerator StaticsDoNotOutliveAPlaySession()
        {
            FluidSimulation simulation = rig.Create();
            yield return Until(simulation);
            Assert.That(FluidSimulation.Active, Is.Not.Empty);
            FluidSimulation.ResetStatics();
            Assert.That(FluidSimulation.Active, Is.Empty);
            simulation.enabled = false;
            simulation.enabled = true;
            Assert.That(FluidSimulation.Active, Is.EqualTo(new[] { simulation }));
        }

        private static IEnumerator Until(FluidSimulation simulation)
        {
            for (int frame = 0; frame < 5 && !simulation.IsRunning; frame++) yield return null;
            Assert.That(simulation.IsRunning, simulation.StatusMessage);
        }
    }
}
