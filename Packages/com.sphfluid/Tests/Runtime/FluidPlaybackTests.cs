using System;
using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>A liquid from files on a simulation: the same particles, views and readings as if it were stepped, and every way to move in time.</summary>
    public sealed class FluidPlaybackTests
    {
        const float Frame = 1f / 64f;
        const object First = null; // the first frame of a test has a time of its own

        SimulationRig rig;
        SequenceFiles files;
        FluidSimulation simulation;
        FluidPlayback playback;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig(Frame);
            files = new SequenceFiles();
        }

        [TearDown]
        public void TearDown()
        {
            rig.Dispose();
            files.Dispose();
        }

        [UnityTest]
        public IEnumerator ARecordedLiquidIsPlayedToTheBit([Values(0.05f, 0.2f)] float spacing)
        {
            yield return First;
            FluidSimulation recorded = rig.Create("Recorded");
            recorded.Spacing = spacing;
            var states = new List<FluidParticle[]>();
            var times = new List<double>();
            using (var writer = new FluidSequenceWriter(files.Folder, recorded.DomainSize, recorded.Spacing, "this test"))
            {
                for (int i = 0; i < 13; i++)
                {
                    yield return null;
                    if (!recorded.IsRunning) recorded.StartSimulation();
                    if (times.Count > 0 && recorded.SimulatedTime == times[times.Count - 1]) continue;
                    states.Add(SimulationRig.Read(recorded));
                    times.Add(recorded.SimulatedTime);
                    writer.Write(recorded);
                }
            }
            recorded.enabled = false;

            Open(spacing, loop: FluidPlaybackLoop.None);
            playback.Clock = FluidPlaybackClock.Manual;
            foreach (int frame in new[] { 0, 1, 2, 5, 3, states.Count - 1, 0 })
            {
                playback.Time = (float)(times[frame] - times[0]);
                yield return null;
                FluidParticle[] shown = SimulationRig.Read(simulation);
                Assert.That(shown.Length, Is.EqualTo(states[frame].Length));
                for (int i = 0; i < shown.Length; i++)
                    Assert.That((shown[i].Id, shown[i].Position.Equals(states[frame][i].Position), shown[i].VelT0.Equals(states[frame][i].VelT0)), Is.EqualTo((states[frame][i].Id, true, true)),
                        $"{i} of frame {frame}");
                Assert.That((playback.CurrentFrame, simulation.SimulatedTime, simulation.ParticleCount), Is.EqualTo((frame, times[frame], shown.Length)));
            }
            Assert.That((playback.FrameCount, playback.SequenceSpacing, playback.SequenceDomainSize, playback.Source),
                Is.EqualTo((states.Count, spacing, recorded.DomainSize, "this test")));
            Assert.That(simulation.Messages, Is.Empty);
        }

        [UnityTest]
        public IEnumerator TimeGoesOnByTheFrameAndStaysAtTheEnd()
        {
            yield return First;
            WriteDrift(9, Frame);
            Open();
            int ended = 0;
            for (int i = 0; i < 12; i++)
            {
                yield return null;
                if (i == 0) playback.Ended += _ => ended++;
                Assert.That(CentreX(), Is.EqualTo(0.01f * Math.Min(i, 8)).Within(1e-6f), $"frame {i}");
                Assert.That((playback.CurrentFrame, playback.IsPlaying, playback.IsBuffering), Is.EqualTo((Math.Min(i, 8), i < 8, false)));
            }
            Assert.That(ended, Is.EqualTo(1));
            playback.Play();
            yield return null;
            Assert.That(CentreX(), Is.Zero.Within(1e-6f));
            playback.Pause();
            for (int i = 0; i < 3; i++) yield return null;
            Assert.That((CentreX(), playback.IsPlaying), Is.EqualTo((0f, false)));
        }

        [UnityTest]
        public IEnumerator HalfSpeedShowsTheHalvesBetweenFrames()
        {
            yield return First;
            WriteDrift(5, 4f * Frame);
            Open(speed: 0.5f);
            for (int i = 0; i < 32; i++)
            {
                yield return null;
                Assert.That(CentreX(), Is.EqualTo(0.01f * i / 8f).Within(1e-6f), $"frame {i}");
                FluidParticle[] particles = SimulationRig.Read(simulation);
                Assert.That(particles[0].VelT0.x, Is.EqualTo(0.01f / (4f * Frame)).Within(1e-4f));
            }
        }

        static readonly string[] Rounds =
        {
            "Repeat 1: 0 1 2 3 4 1 2 3 4 1", "PingPong 1: 0 1 2 3 4 3 2 1 0 1", "None -1: 0 0 0", "Repeat -1: 0 3 2 1 0 3 2", "PingPong -1: 0 1 2 3 4 3 2",
        };

        [UnityTest]
        public IEnumerator PastTheEndsItLoops([ValueSource(nameof(Rounds))] string round)
        {
            yield return First;
            string[] words = round.Split(new[] { ": ", " " }, 3, StringSplitOptions.None);
            string expected = words[2];
            WriteDrift(5, Frame);
            Open(speed: int.Parse(words[1]), loop: (FluidPlaybackLoop)Enum.Parse(typeof(FluidPlaybackLoop), words[0]));
            var shown = new List<int>();
            for (int i = 0; i < expected.Split(' ').Length; i++)
            {
                yield return null;
                shown.Add(Mathf.RoundToInt(CentreX() / 0.01f));
            }
            Assert.That(string.Join(" ", shown), Is.EqualTo(expected));
        }

        [UnityTest]
        public IEnumerator ASoughtTimeIsShownInTheNextFrame()
        {
            yield return First;
            WriteDrift(200, Frame);
            Open();
            playback.MemoryBudget = 1;
            yield return null;
            foreach (float time in new[] { 150f, 3f, 199f, 70.5f })
            {
                playback.Seek(time * Frame);
                yield return null;
                Assert.That(CentreX(), Is.EqualTo(0.001f * time).Within(2e-6f), $"{time}");
                yield return null;
                Assert.That(CentreX(), Is.EqualTo(0.001f * Math.Min(199f, time + 1f)).Within(2e-6f), $"after {time}");
            }
            Assert.That(() => playback.Seek(float.NaN), Throws.TypeOf<ArgumentOutOfRangeException>());
        }

        [UnityTest]
        public IEnumerator ManualTimeIsScrubbedBothWays()
        {
            yield return First;
            WriteDrift(9, Frame);
            Open();
            playback.Clock = FluidPlaybackClock.Manual;
            foreach (float time in new[] { 0f, 2f, 2.25f, 7f, 1f, 1f, 8f, 100f, -3f })
            {
                playback.Time = time * Frame;
                yield return null;
                Assert.That(CentreX(), Is.EqualTo(0.01f * Mathf.Clamp(time, 0f, 8f)).Within(2e-6f), $"{time}");
                Assert.That(playback.Time, Is.EqualTo(time * Frame), "whoever keys it owns it");
            }
        }

        [UnityTest]
        public IEnumerator PauseAndTimeScaleOfTheSimulationAct()
        {
            yield return First;
            WriteDrift(100, Frame);
            Open();
            yield return null;
            simulation.TimeScale = 2f;
            yield return null;
            Assert.That(CentreX(), Is.EqualTo(0.002f).Within(1e-6f));
            simulation.Paused = true;
            for (int i = 0; i < 3; i++) yield return null;
            Assert.That(CentreX(), Is.EqualTo(0.002f).Within(1e-6f));
        }

        [UnityTest]
        public IEnumerator FilesThatAreMissingCutOrAlteredHoldTheFrameAndAreNamedOnce()
        {
            yield return First;
            WriteDrift(8, Frame);
            File.Delete(files["frame-00002.ply"]);
            byte[] whole = File.ReadAllBytes(files["frame-00004.ply"]);
            File.WriteAllBytes(files["frame-00004.ply"], whole.Take(100).ToArray());
            whole[whole.Length - 3] ^= 1;
            File.WriteAllBytes(files["frame-00005.ply"], whole);
            Open(loop: FluidPlaybackLoop.Repeat);
            foreach (string name in new[] { "00002.ply' cannot be read", "00004.ply' was cut", "00005.ply' was altered" })
                LogAssert.Expect(LogType.Warning, new Regex($"'Playback': 'frame-{name}.*so its frame is not shown: the one before it stays"));
            var shown = new List<int>();
            for (int i = 0; i < 15; i++)
            {
                yield return null;
                shown.Add(Mathf.RoundToInt(CentreX() / 0.01f));
                Assert.That(playback.IsBuffering, Is.False);
            }
            Assert.That(string.Join(" ", shown), Is.EqualTo("0 1 1 3 3 3 6 7 1 1 3 3 3 6 7"));
            Assert.That(simulation.Messages.Count(m => m.Issue == FluidIssue.PlaybackFrame), Is.EqualTo(3));
        }

        [UnityTest]
        public IEnumerator AMendedFileIsPlayedAfterReload()
        {
            yield return First;
            WriteDrift(3, Frame);
            byte[] whole = File.ReadAllBytes(files["frame-00001.ply"]);
            File.WriteAllBytes(files["frame-00001.ply"], new byte[5]);
            Open();
            playback.Clock = FluidPlaybackClock.Manual;
            playback.Time = Frame;
            LogAssert.Expect(LogType.Warning, new Regex("00001.ply' was cut"));
            yield return null;
            yield return null;
            Assert.That(playback.CurrentFrame, Is.EqualTo(-1));
            File.WriteAllBytes(files["frame-00001.ply"], whole);
            Assert.That(playback.Reload(), Is.True);
            yield return null;
            Assert.That((playback.CurrentFrame, CentreX()), Is.EqualTo((1, 0.01f)));
        }

        [UnityTest]
        public IEnumerator ParticlesThatComeAndGoAreCounted()
        {
            yield return First;
            var frames = new[] { 3, 0, 257, 1, 31 };
            files.Write(frames.Select((_, i) => i * (double)Frame).ToArray(), i => ParticleSets.Random(frames[i], 0.3f * Vector3.one, 1f, i), 0.4f * Vector3.one, SimulationRig.Spacing);
            Open();
            foreach (int count in frames)
            {
                yield return null;
                Assert.That(simulation.ParticleCount, Is.EqualTo(count));
                Assert.That(SimulationRig.Read(simulation).Length, Is.EqualTo(count));
                Assert.That(simulation.RemovedParticles, Is.Zero);
            }
        }

        [UnityTest]
        public IEnumerator ParticlesOutsideOfTheDomainAreLeftOutCountedAndNamedOnce()
        {
            yield return First;
            var outside = new[] { new FluidParticle(Vector3.zero, Vector3.zero, 0u), new FluidParticle(0.21f * Vector3.right, Vector3.zero, 1u), new FluidParticle(Vector3.up, Vector3.zero, 2u) };
            files.Write(new[] { 0.0, Frame, 2.0 * Frame }, _ => outside, new Vector3(0.5f, 3f, 0.4f), SimulationRig.Spacing);
            Open();
            LogAssert.Expect(LogType.Warning, new Regex(@"2 particles of 'frame-00000.ply' are outside of the domain of 0.4 × 0.4 × 0.4 m.*made in one of 0.5 × 3 × 0.4 m.*Enlarge"));
            for (int i = 0; i < 3; i++) yield return null;
            Assert.That((simulation.ParticleCount, playback.LeftOutParticles), Is.EqualTo((1, 2)));
            Assert.That(simulation.Messages.Count(m => m.Issue == FluidIssue.PlaybackOutside), Is.EqualTo(1));
        }

        [UnityTest]
        public IEnumerator DisabledOrWithoutAFolderTheSimulationSimulates()
        {
            yield return First;
            WriteDrift(100, Frame);
            Open();
            rig.AddVolume(simulation);
            for (int i = 0; i < 5; i++) yield return null;
            Assert.That((simulation.IsPlayedBack, simulation.ParticleCount), Is.EqualTo((true, 1)));
            FluidSolver played = simulation.Solver;
            playback.enabled = false;
            yield return null;
            yield return null;
            Assert.That((simulation.IsPlayedBack, simulation.ParticleCount, simulation.Solver == played), Is.EqualTo((false, 64, false)));
            float height = SimulationRig.MeanHeight(simulation);
            for (int i = 0; i < 5; i++) yield return null;
            Assert.That(SimulationRig.MeanHeight(simulation), Is.LessThan(height - 0.001f), "it falls");

            playback.enabled = true;
            yield return null;
            Assert.That((simulation.IsPlayedBack, simulation.ParticleCount), Is.EqualTo((true, 1)));
            LogAssert.Expect(LogType.Error, new Regex("'Playback': 'no such folder' is no folder, so nothing is played"));
            playback.Folder = "no such folder";
            yield return null;
            Assert.That((simulation.IsPlayedBack, playback.IsOpen, playback.Problem?.Issue), Is.EqualTo((false, false, (FluidIssue?)FluidIssue.PlaybackInvalid)));
            yield return null;
            Assert.That(simulation.ParticleCount, Is.EqualTo(64));
        }

        [UnityTest]
        public IEnumerator WhatStepsALiquidIsRefusedMeanwhile()
        {
            yield return First;
            WriteDrift(100, Frame);
            Open();
            yield return null;
            Assert.That(() => simulation.Save(new MemoryStream()), Throws.InvalidOperationException.With.Message.Contains("played from files"));
            Assert.That(() => simulation.AddImpulse(Vector3.zero, 0.1f, Vector3.up), Throws.InvalidOperationException);
            Assert.That(() => simulation.RemoveLiquid(Vector3.zero, 0.1f), Throws.InvalidOperationException);
            LogAssert.Expect(LogType.Error, new Regex("played from files, so the save was not restored"));
            Assert.That(simulation.Restore(new MemoryStream()), Is.False);
            yield return null;
            Assert.That(simulation.IsPlayedBack);
        }

        [UnityTest]
        public IEnumerator EmittersAndZonesDoNothingAndAreNamed()
        {
            yield return First;
            WriteDrift(100, Frame);
            Open();
            foreach (Type part in new[] { typeof(FluidEmitter), typeof(FluidDrain), typeof(FluidForceZone) })
            {
                GameObject holder = rig.NewObject(part.Name);
                holder.transform.SetParent(simulation.transform, false);
                holder.AddComponent(part);
            }
            for (int i = 0; i < 10; i++) yield return null;
            Assert.That(simulation.ParticleCount, Is.EqualTo(1));
            Assert.That(simulation.Messages.Single().Text, Does.Contain("so 3 emitters, drains and force zones do nothing"));
        }

        [UnityTest]
        public IEnumerator WhitewaterLivesOnThroughPlayAndBeginsAnewAfterAJump()
        {
            yield return First;
            yield return RecordSplash();
            Open(spacing: 0.025f, domain: 0.6f);
            FluidWhitewater whitewater = simulation.gameObject.AddComponent<FluidWhitewater>();
            FluidDiagnostics diagnostics = simulation.gameObject.AddComponent<FluidDiagnostics>();
            diagnostics.Interval = 1;
            for (int i = 0; i < 40; i++) yield return null;
            Assert.That(diagnostics.MeasurementCount, Is.GreaterThan(10));
            Assert.That(diagnostics.Statistics.MaxSpeed, Is.GreaterThan(1f));
            Assert.That(simulation.Messages.Where(m => m.Issue == FluidIssue.Diagnosis), Is.Empty);
            long born = whitewater.Flow.ReadCounts().Born;
            int alive = (int)whitewater.Flow.ReadCounts().Particles;
            Assert.That(alive, Is.GreaterThan(100));
            playback.Pause();
            for (int i = 0; i < 3; i++) yield return null;
            Assert.That(whitewater.Flow.ReadCounts().Particles, Is.EqualTo(alive));
            playback.Play();
            yield return null;
            Assert.That(whitewater.Flow.ReadCounts().Particles, Is.GreaterThan(alive / 2), "it lives on");
            playback.Seek(2f * Frame);
            yield return null;
            Assert.That(whitewater.Flow.ReadCounts().Particles, Is.Zero, "after a jump");
            Assert.That(born, Is.Positive);
        }

        [UnityTest]
        public IEnumerator QueriesAndInstrumentsReadWhatIsPlayed()
        {
            yield return First;
            files.Write(Enumerable.Range(0, 200).Select(i => i * (double)Frame).ToArray(),
                _ => ParticleSets.Lattice(new Vector3Int(8, 4, 8), 0.05f, 0f, 1).Select(p => new FluidParticle(p.Position - 0.1f * Vector3.up, 0.5f * Vector3.right, p.Id)).ToArray(),
                0.4f * Vector3.one, SimulationRig.Spacing);
            Open();
            playback.Interpolate = false;
            FluidGauge gauge = Place<FluidGauge>(new Vector3(0f, -0.2f, 0f));
            gauge.Length = 0.4f;
            gauge.AveragingTime = 0f;
            FluidProbe probe = Place<FluidProbe>(new Vector3(0f, -0.1f, 0f));
            probe.Kind = FluidProbeKind.Velocity;
            FluidProbe pressure = Place<FluidProbe>(new Vector3(0f, -0.2f, 0f));
            LogAssert.Expect(LogType.Warning, new Regex("played from files, which hold no force on walls"));
            for (int i = 0; i < 10; i++) yield return null;
            gauge.ReadNow();
            probe.ReadNow();
            Assert.That(gauge.Height, Is.EqualTo(0.2f).Within(0.02f));
            Assert.That((probe.Velocity - 0.5f * Vector3.right).magnitude, Is.LessThan(0.01f));
            Assert.That(pressure.HasValue, Is.False);
            Assert.That(simulation.Queries.AnsweredTime, Is.EqualTo(9.0 * Frame).Within(3.0 * Frame));

            playback.Seek(0f);
            yield return null;
            yield return null;
            yield return null;
            gauge.ReadNow();
            Assert.That(gauge.HasValue, "readings begin anew where time goes back");
            Assert.That(gauge.ReadTime, Is.LessThan(4.0 * Frame));
        }

        [UnityTest]
        public IEnumerator AFrameOfPlayMakesNoGarbage()
        {
            yield return First;
            const int count = 257;
            FluidParticle[] particles = ParticleSets.Random(count, 0.3f * Vector3.one, 0f, 3);
            files.Write(Enumerable.Range(0, 300).Select(i => i * (double)Frame).ToArray(), _ => particles, 0.4f * Vector3.one, SimulationRig.Spacing);
            Open(speed: 0.7f, loop: FluidPlaybackLoop.Repeat);
            var meter = simulation.gameObject.AddComponent<BeginMeter>();
            simulation.gameObject.AddComponent<EndMeter>().Begin = meter;
            long most = 0;
            for (int i = 0; i < 40; i++)
            {
                yield return null;
                if (i > 10) most = Math.Max(most, meter.Made);
            }
            Assert.That(most, Is.Zero, "the component");

            SequencePlayer player = playback.Player;
            playback.WaitForFrames = true;
            for (int i = 1; i < 60; i++)
            {
                long before = GC.GetAllocatedBytesForCurrentThread();
                player.MoveTo(i * 0.7 * Frame, 1, FluidPlaybackLoop.Repeat, false, true);
                bool shows = player.TryTake(0.4f * Vector3.one, Vector3.zero, false, out PlayedFrame _);
                long made = GC.GetAllocatedBytesForCurrentThread() - before;
                Assert.That(shows, $"{i}");
                if (i > 10) most = Math.Max(most, made);
            }
            Assert.That(most, Is.Zero, "the particles");
        }

        // Before and after the playback's own frame.
        [DefaultExecutionOrder(39)]
        sealed class BeginMeter : MonoBehaviour
        {
            public long Before { get; private set; }

            public long Made { get; set; }

            void LateUpdate() => Before = GC.GetAllocatedBytesForCurrentThread();
        }

        [DefaultExecutionOrder(41)]
        sealed class EndMeter : MonoBehaviour
        {
            public BeginMeter Begin { get; set; }

            void LateUpdate() => Begin.Made = GC.GetAllocatedBytesForCurrentThread() - Begin.Before;
        }

        [UnityTest]
        public IEnumerator UnseenNothingIsReadAndTimeGoesOn()
        {
            yield return First;
            WriteDrift(100, Frame);
            Open();
            playback.CullUnseen = true;
            for (int i = 0; i < 5; i++) yield return null;
            Assert.That(playback.Player.Reads, Is.Zero);
            Assert.That((playback.CurrentFrame, playback.Time), Is.EqualTo((-1, 4f * Frame)));
            Camera camera = rig.NewObject("Camera").AddComponent<Camera>();
            camera.cullingMask = ~0;
            camera.transform.position = new Vector3(0f, 0f, -3f);
            yield return null;
            Assert.That(playback.CurrentFrame, Is.EqualTo(5));
            camera.transform.position = new Vector3(0f, 0f, 3f);
            for (int i = 0; i < 3; i++) yield return null;
            Assert.That((playback.CurrentFrame, playback.Time), Is.EqualTo((5, 8f * Frame)));
        }

        [UnityTest]
        public IEnumerator OtherOptionsBeginAnew()
        {
            yield return First;
            WriteDrift(9, Frame);
            Open();
            yield return null;
            SequencePlayer before = playback.Player;
            yield return null;
            Assert.That(playback.Player, Is.SameAs(before));
            playback.Interpolate = false;
            playback.Clock = FluidPlaybackClock.Manual;
            playback.Time = 2.75f * Frame;
            yield return null;
            Assert.That(playback.Player, Is.Not.SameAs(before));
            Assert.That(CentreX(), Is.EqualTo(0.03f).Within(1e-6f), "the nearer frame");
        }

        T Place<T>(Vector3 position) where T : Component
        {
            GameObject holder = rig.NewObject(typeof(T).Name);
            holder.transform.SetParent(simulation.transform, false);
            holder.transform.localPosition = position;
            return holder.AddComponent<T>();
        }

        IEnumerator RecordSplash()
        {
            FluidSimulation splash = rig.Create("Splash", liquid: false);
            splash.DomainSize = 0.6f * Vector3.one;
            splash.Spacing = 0.025f;
            FluidVolume water = rig.AddVolume(splash);
            water.Size = 0.3f * Vector3.one;
            water.transform.localPosition = new Vector3(-0.15f, 0.15f, -0.15f);
            using (var writer = new FluidSequenceWriter(files.Folder, splash.DomainSize, splash.Spacing))
            {
                for (int i = 0; i < 50; i++)
                {
                    yield return null;
                    if (splash.IsRunning && (writer.FrameCount == 0 || splash.SimulatedTime > 0.0)) writer.Write(splash);
                }
            }
            splash.enabled = false;
        }

        // One particle that goes a hundredth of a metre a frame, or a thousandth in long sequences.
        void WriteDrift(int frames, float interval)
        {
            float step = frames < 50 ? 0.01f : 0.001f;
            files.Write(Enumerable.Range(0, frames).Select(i => i * (double)interval).ToArray(),
                i => new[] { new FluidParticle(new Vector3(step * i, 0f, 0f), new Vector3(step / interval, 0f, 0f), 5u) }, 0.4f * Vector3.one, SimulationRig.Spacing);
        }

        void Open(float spacing = SimulationRig.Spacing, float speed = 1f, FluidPlaybackLoop loop = FluidPlaybackLoop.None, float domain = 0.4f)
        {
            simulation = rig.Create("Playback", liquid: false);
            simulation.Spacing = spacing;
            simulation.DomainSize = domain * Vector3.one;
            playback = simulation.gameObject.AddComponent<FluidPlayback>();
            playback.Folder = files.Folder;
            playback.Speed = speed;
            playback.Loop = loop;
        }

        float CentreX()
        {
            FluidParticle[] particles = SimulationRig.Read(simulation);
            return particles.Length == 0 ? float.NaN : particles.Average(p => p.Position.x);
        }
    }
}
