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
    /// <summary>
    /// A liquid from files on a simulation: the same particles as if it were stepped, every way to move in time, and files that cannot be
    /// read.
    /// </summary>
    public sealed class FluidPlaybackTests : PlaybackTest
    {
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
                {
                    Assert.That((shown[i].Id, shown[i].Position.Equals(states[frame][i].Position),
                        shown[i].VelT0.Equals(states[frame][i].VelT0)), Is.EqualTo((states[frame][i].Id, true, true)),
                        $"{i} of frame {frame}");
                }
                Assert.That((playback.CurrentFrame, simulation.SimulatedTime, simulation.ParticleCount),
                    Is.EqualTo((frame, times[frame], shown.Length)));
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

        private static readonly string[] Rounds =
        {
            "Repeat 1: 0 1 2 3 4 1 2 3 4 1", "PingPong 1: 0 1 2 3 4 3 2 1 0 1", "None -1: 0 0 0", "Repeat -1: 0 3 2 1 0 3 2",
            "PingPong -1: 0 1 2 3 4 3 2",
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
            {
                LogAssert.Expect(LogType.Warning,
                    new Regex($"'Playback': 'frame-{name}.*so its frame is not shown: the one before it stays"));
            }
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
            files.Write(frames.Select((_, i) => i * (double)Frame).ToArray(),
                i => ParticleSets.Random(frames[i], 0.3f * Vector3.one, 1f, i), 0.4f * Vector3.one, SimulationRig.Spacing);
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
            var outside = new[] { new FluidParticle(Vector3.zero, Vector3.zero, 0u),
                new FluidParticle(0.21f * Vector3.right, Vector3.zero, 1u), new FluidParticle(Vector3.up, Vector3.zero, 2u) };
            files.Write(new[] { 0.0, Frame, 2.0 * Frame }, _ => outside, new Vector3(0.5f, 3f, 0.4f), SimulationRig.Spacing);
            Open();
            LogAssert.Expect(LogType.Warning,
                new Regex(
                    @"2 particles of 'frame-00000.ply' are outside of the domain of 0.4 × 0.4 × 0.4 m.*made in one of 0.5 × 3 × 0.4 " +
                    @"m.*Enlarge"));
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
            Assert.That((simulation.IsPlayedBack, playback.IsOpen, playback.Problem?.Issue),
                Is.EqualTo((false, false, (FluidIssue?)FluidIssue.PlaybackInvalid)));
            yield return null;
            Assert.That(simulation.ParticleCount, Is.EqualTo(64));
        }
    }
}
