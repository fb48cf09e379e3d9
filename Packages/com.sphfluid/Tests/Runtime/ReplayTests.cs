using System;
using System.Collections;
using System.IO;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Recorded frames are played again, and the first one that differs is found.</summary>
    public sealed class ReplayTests
    {
        private const int Frames = 14;

        private SimulationRig rig;
        private FluidSimulation simulation;
        private Transform gate;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig(1f / 64f);
            simulation = rig.Create();
            gate = rig.NewObject("Gate").transform;
            gate.gameObject.AddComponent<BoxCollider>().size = new Vector3(0.03f, 0.3f, 0.3f);
            Move(0);
        }

        [TearDown]
        public void TearDown()
        {
            LogAssert.ignoreFailingMessages = false;
            rig.Dispose();
        }

        private void Move(int frame, float farther = 0f) => gate.position = new Vector3(0.12f - 0.003f * frame - farther, -0.02f, 0f);

        private IEnumerator Begin()
        {
            while (!simulation.IsRunning) yield return null;
            for (int i = 0; i < 3; i++) yield return null;
        }

        // Frames of several lengths, a pause, single steps and slow motion.
        private IEnumerator Record(MemoryStream stream)
        {
            yield return Begin();
            using (var recording = new FluidRecording(simulation, stream))
            {
                for (int frame = 0; frame < Frames; frame++)
                {
                    Time.captureDeltaTime = frame % 3 == 1 ? 1f / 100f : 1f / 64f;
                    simulation.Paused = frame == 4 || frame == 5;
                    simulation.TimeScale = frame > 8 ? 0.7f : 1f;
                    Move(frame);
                    if (frame == 5)
                    {
                        simulation.StepOnce();
                        simulation.StepOnce();
                    }
                    yield return null;
                }
                Assert.That(recording.FrameCount, Is.EqualTo(Frames));
                Assert.That(recording.IsRecording);
            }
            simulation.Paused = false;
            simulation.TimeScale = 1f;
            Time.captureDeltaTime = 1f / 50f;
        }

        private IEnumerator Play(FluidReplay replay, int wrongFrame = -1)
        {
            for (int frame = 0; frame < Frames; frame++)
            {
                Move(frame, frame == wrongFrame ? 0.02f : 0f);
                yield return null;
            }
            Assert.That(replay.FrameCount, Is.EqualTo(Frames));
        }

        [UnityTest]
        public IEnumerator ARecordingIsPlayedAgainToTheBit()
        {
            var stream = new MemoryStream();
            yield return Record(stream);
            ulong end = simulation.ComputeStateHash();
            yield return Begin();
            stream.Position = 0;
            Move(0);
            using (var replay = new FluidReplay(simulation, stream))
            {
                Assert.That(replay.IsPlaying);
                yield return Play(replay);
                Assert.That((replay.FirstDifference, replay.IsPlaying, replay.IsDamaged), Is.EqualTo((-1, false, false)));
                Assert.That(simulation.ComputeStateHash(), Is.EqualTo(end));
                long steps = simulation.StepCount;
                yield return null;
                Assert.That(simulation.StepCount, Is.GreaterThan(steps), "it goes on");
                Assert.That(replay.FrameCount, Is.EqualTo(Frames));
            }
        }

        [UnityTest]
        public IEnumerator TheFirstFrameThatDiffersIsNamed([Values(0, 7)] int frame)
        {
            var stream = new MemoryStream();
            yield return Record(stream);
            stream.Position = 0;
            Move(0);
            using (var replay = new FluidReplay(simulation, stream))
            {
                yield return Play(replay, frame);
                Assert.That(replay.FirstDifference, Is.EqualTo(frame));
            }
        }

        [UnityTest]
        public IEnumerator ARecordingThatIsCutOrAlteredIsPlayedUpToThere([Values] bool cut)
        {
            var stream = new MemoryStream();
            yield return Record(stream);
            byte[] bytes = stream.ToArray();
            if (cut) Array.Resize(ref bytes, bytes.Length - 5);
            else bytes[bytes.Length - 30] ^= 4; // in the last frame but one
            Move(0);
            using (var replay = new FluidReplay(simulation, new MemoryStream(bytes)))
            {
                int frame = 0;
                while (replay.IsPlaying)
                {
                    Move(frame++);
                    yield return null;
                }
                Assert.That((replay.FrameCount, replay.FirstDifference, replay.IsDamaged),
                    Is.EqualTo((cut ? Frames - 1 : Frames - 2, -1, true)));
            }
        }

        [UnityTest]
        public IEnumerator OneAtATimeAndOnlyOfALiquidThatRuns()
        {
            Assert.That(() => new FluidRecording(null, Stream.Null), Throws.ArgumentNullException);
            Assert.That(() => new FluidReplay(simulation, null), Throws.ArgumentNullException);
            Assert.That(() => new FluidRecording(simulation, new MemoryStream()), Throws.InvalidOperationException);
            yield return Begin();
            LogAssert.ignoreFailingMessages = true;
            Assert.That(() => new FluidReplay(simulation, new MemoryStream()),
                Throws.TypeOf<InvalidDataException>().With.Message.Contains("cut"));
            LogAssert.ignoreFailingMessages = false;
            using (var recording = new FluidRecording(simulation, new MemoryStream()))
            {
                Assert.That(() => new FluidRecording(simulation, new MemoryStream()),
                    Throws.InvalidOperationException.With.Message.Contains("already"));
                simulation.StopSimulation();
                Assert.That(recording.IsRecording, Is.False);
            }
            simulation.StartSimulation();
            using (new FluidRecording(simulation, new MemoryStream())) yield return null;
        }
    }
}
