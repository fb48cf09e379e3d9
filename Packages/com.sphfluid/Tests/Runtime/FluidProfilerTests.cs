using System.Collections;
using NUnit.Framework;
using Unity.Profiling;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>The counters in the Profiler are what all liquids together did in a frame.</summary>
    public sealed class FluidProfilerTests
    {
        private const int Frames = 6;

        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig();

        [TearDown]
        public void TearDown() => rig.Dispose();

        [UnityTest]
        public IEnumerator ParticlesStepsAndMemoryAreSumsOverTheLiquids()
        {
            FluidSimulation first = rig.Create("First"), second = rig.Create("Second", true, new UnityEngine.Vector3(2f, 0f, 0f));
            yield return Wait();
            using (ProfilerRecorder particles = Recorder(FluidProfiler.Particles), steps = Recorder(FluidProfiler.Steps),
                memory = Recorder(FluidProfiler.GpuMemory))
            {
                long before = first.StepCount + second.StepCount;
                yield return Wait();
                Assert.That(Sum(steps), Is.EqualTo(first.StepCount + second.StepCount - before).And.GreaterThan(0));
                Assert.That(particles.LastValue, Is.EqualTo(first.Solver.LiveCount + second.Solver.LiveCount));
                Assert.That(memory.LastValue, Is.EqualTo(first.GpuBytes + second.GpuBytes));
                Assert.That(memory.UnitType, Is.EqualTo(ProfilerMarkerDataUnit.Bytes));
                first.StopSimulation();
                second.StopSimulation();
                yield return Wait();
                Assert.That(particles.LastValue, Is.Zero);
                Assert.That(memory.LastValue, Is.Zero);
            }
        }

        [UnityTest]
        public IEnumerator FramesAtTheCapAreCounted()
        {
            FluidSimulation tank = rig.Create("Tank");
            tank.MaxSubstepsPerFrame = 1;
            rig.Profile.SoundSpeedRatio = 20f;
            yield return Wait();
            using (ProfilerRecorder caps = Recorder(FluidProfiler.CapHits))
            {
                long before = tank.CapHits;
                yield return Wait();
                Assert.That(tank.CapHits - before, Is.EqualTo(Frames));
                Assert.That(Sum(caps), Is.EqualTo(Frames));
            }
        }

        [UnityTest]
        public IEnumerator SurfacesAddTheirTrianglesSprayAndMemory()
        {
            FluidSimulation tank = rig.Create("Tank");
            var surface = tank.gameObject.AddComponent<FluidSurfaceRenderer>();
            using (new PictureRig(32, 32, 0.3f))
            using (ProfilerRecorder triangles = Recorder(FluidProfiler.Triangles), memory = Recorder(FluidProfiler.GpuMemory))
            {
                for (int i = 0; i < 4; i++) yield return Wait();
                Assert.That(surface.Status.Triangles, Is.GreaterThan(0));
                Assert.That(triangles.LastValue, Is.GreaterThan(0));
                Assert.That(memory.LastValue, Is.EqualTo(tank.GpuBytes + surface.GpuBytes));
            }
        }

        private static ProfilerRecorder Recorder(string counter) =>
            ProfilerRecorder.StartNew(new ProfilerCategory(FluidProfiler.Category), counter, 64);

        private static long Sum(ProfilerRecorder recorder)
        {
            long sum = 0;
            for (int i = 0; i < recorder.Count; i++) sum += recorder.GetSample(i).Value;
            return sum;
        }

        private static IEnumerator Wait()
        {
            for (int i = 0; i < Frames; i++) yield return null;
        }
    }
}
