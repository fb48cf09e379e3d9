using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Figures that are shown before a start are those that it then has.</summary>
    public sealed class PreviewFiguresTests
    {
        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig();

        [TearDown]
        public void TearDown() => rig.Dispose();

        [Test]
        public void MemoryBeforeIsMemoryAfter(
            [Values(FluidMethodKind.Standard, FluidMethodKind.Thesis, FluidMethodKind.ThesisPrinted)] FluidMethodKind method,
            [Values(0, 1, 2)] int colliders, [Values(0.05f, 0.023f)] float spacing)
        {
            FluidSimulation simulation = rig.Create();
            simulation.Method = method;
            simulation.Spacing = spacing;
            var made = new List<GameObject>();
            for (int i = 0; i < colliders; i++) made.Add(Obstacle(i));
            try
            {
                FluidPreview preview = PreviewOf(simulation);
                Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
                Assert.That(preview.Lack, Is.Null);
                Assert.That((preview.Particles, preview.GpuBytes), Is.EqualTo(((long)simulation.ParticleCount, simulation.GpuBytes)));
                Assert.That(preview.Constants.TimeStep, Is.EqualTo(simulation.Solver.Settings.TimeStep));
            }
            finally
            {
                made.ForEach(Object.DestroyImmediate);
            }
        }

        [TestCase(FluidTimeStepMode.Automatic, true, FluidCapacityPolicy.Grow, false)]
        [TestCase(FluidTimeStepMode.Automatic, true, FluidCapacityPolicy.Grow, true)]
        [TestCase(FluidTimeStepMode.Fixed, false, FluidCapacityPolicy.Grow, true)]
        [TestCase(FluidTimeStepMode.Adaptive, false, FluidCapacityPolicy.Fixed, false)]
        public void MemoryFollowsTheSettings(FluidTimeStepMode mode, bool sleeps, FluidCapacityPolicy policy, bool inParts)
        {
            foreach (FluidMethodKind method in new[] { FluidMethodKind.Standard, FluidMethodKind.Thesis })
            {
                FluidSimulation simulation = rig.Create(method.ToString());
                simulation.Method = method;
                simulation.TimeStepMode = mode;
                simulation.SleepsAtRest = sleeps;
                simulation.PartsSleep = inParts;
                simulation.CapacityPolicy = policy;
                simulation.Capacity = 1000;
                FluidPreview preview = PreviewOf(simulation);
                Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
                Assert.That(preview.GpuBytes, Is.EqualTo(simulation.GpuBytes), method.ToString());
                Object.DestroyImmediate(simulation.gameObject);
            }
        }

        [UnityTest]
        public IEnumerator StepsAreTimedWhereTheDeviceCan()
        {
            if (!StepTimer.IsSupported) Assert.Ignore("This device reports no GPU times.");
            FluidSimulation simulation = rig.Create();
            simulation.BeginTiming();
            simulation.BeginTiming();
            for (int frame = 0; frame < 20; frame++) yield return null;
            StepTimer timer = simulation.Timer;
            Assert.That(timer.FrameCount, Is.InRange(5, 20));
            Assert.That(timer.StepsAFrame, Is.GreaterThan(1.0).And.LessThanOrEqualTo(simulation.StepCount));
            Assert.That(timer.MillisecondsAFrame, Is.GreaterThan(0.0));
            Assert.That(timer.NanosecondsAParticleStep * 64.0 * timer.StepsAFrame * 1e-6,
                Is.EqualTo(timer.MillisecondsAFrame).Within(0.1).Percent);
            simulation.EndTiming();
            Assert.That(simulation.Timer, Is.SameAs(timer), "another still asks");
            simulation.EndTiming();
            Assert.That(simulation.Timer, Is.Null);
            yield return null;
        }

        [UnityTest]
        public IEnumerator StepsOfAFrameInPartsCountOnce()
        {
            if (!StepTimer.IsSupported) Assert.Ignore("This device reports no GPU times.");
            using (var timer = new StepTimer())
            using (var cmd = new CommandBuffer())
            {
                const int steps = 8;
                for (int frame = 0; frame < 20; frame++)
                {
                    cmd.Clear();
                    timer.Begin(cmd, steps, 100);
                    for (int part = 0; part < 2; part++)
                    {
                        timer.EndPart(cmd);
                        Graphics.ExecuteCommandBuffer(cmd);
                        cmd.Clear();
                        timer.BeginPart(cmd);
                    }
                    timer.End(cmd, steps);
                    Graphics.ExecuteCommandBuffer(cmd);
                    yield return null;
                }
                Assert.That(timer.FrameCount, Is.InRange(5, 20));
                Assert.That(timer.StepsAFrame * timer.FrameCount, Is.InRange(10.0 * steps, 20.0 * steps),
                    "times may come for two frames at once");
            }
        }

        private static FluidPreview PreviewOf(FluidSimulation simulation)
        {
            using (var memory = new PreviewMemory())
            {
                List<FluidMessage> messages = null;
                memory.Look(simulation.Spec, FluidScene.Volumes(simulation), 0.0, null, ref messages);
                Assert.That(memory.Preview, Is.Not.Null, FluidReports.Worst(messages));
                return memory.Preview;
            }
        }

        private static GameObject Obstacle(int number)
        {
            GameObject made = GameObject.CreatePrimitive(number == 0 ? PrimitiveType.Cube : PrimitiveType.Sphere);
            made.layer = SimulationRig.Layer;
            made.transform.position = new Vector3(0.05f * number, -0.15f, 0f);
            made.transform.localScale = new Vector3(0.3f, 0.05f, 0.3f);
            return made;
        }
    }
}
