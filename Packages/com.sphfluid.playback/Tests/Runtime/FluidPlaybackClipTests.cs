using System;
using System.Collections;
using System.Collections.Generic;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Playables;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>What a clip shows at a time, how long it lasts, and what it says where it has no playback.</summary>
    public sealed class FluidPlaybackClipTests : PlaybackClipTest
    {
        [UnityTest]
        public IEnumerator ScrubbingShowsTheFrameOfTheTimeBothWays()
        {
            yield return First;
            WriteDrift(9, Frame);
            Open();
            Playable playable = Add(Clip());
            graph.Play();
            foreach (float time in new[] { 0f, 2f, 2.25f, 7f, 1f, 1f, 8f, 100f })
            {
                ShowAt(playable, time * Frame);
                yield return null;
                Assert.That(CentreX(), Is.EqualTo(0.01f * Mathf.Min(time, 8f)).Within(2e-6f), $"{time}");
                Assert.That(playback.Time, Is.EqualTo(time * Frame));
            }
        }

        [UnityTest]
        public IEnumerator StartAndSpeedPlaceTheClipInTheSequence()
        {
            yield return First;
            WriteDrift(9, Frame);
            Open();
            FluidPlaybackClip clip = Clip();
            Playable playable = Add(clip);
            foreach ((float start, float speed, float time, float expected) in new[] { (2f, 1f, 3f, 5f), (2f, 0.5f, 4f, 4f),
                (8f, -1f, 2f, 6f), (8f, -2f, 3f, 2f), (3f, 0f, 5f, 3f), (1f, -1f, 4f, 0f) })
            {
                (clip.Start, clip.Speed) = (start * Frame, speed);
                ShowAt(playable, time * Frame);
                yield return null;
                Assert.That(CentreX(), Is.EqualTo(0.01f * expected).Within(2e-6f), $"{start} + {speed} · {time}");
            }
            Assert.That(() => clip.Start = -1f, Throws.TypeOf<ArgumentOutOfRangeException>());
            Assert.That(() => clip.Start = float.NaN, Throws.TypeOf<ArgumentOutOfRangeException>());
            Assert.That(() => clip.Speed = float.PositiveInfinity, Throws.TypeOf<ArgumentOutOfRangeException>());
            Assert.That((clip.Start, clip.Speed), Is.EqualTo((Frame, -1f)));
        }

        [UnityTest]
        public IEnumerator AfterHoursTimesAreAsExactAsAtTheBeginning()
        {
            yield return First;
            files.Write(new[] { 0.0, 8192.0, 8192.0 + Frame },
                i => new[] { new FluidParticle(new Vector3(0.1f * i, 0f, 0f), new Vector3(0.1f / Frame, 0f, 0f), 5u) },
                0.4f * Vector3.one, SimulationRig.Spacing);
            Open();
            Playable playable = Add(Clip());
            foreach (double share in new[] { 0.3, 0.4, 0.61 })
            {
                ShowAt(playable, 8192.0 + share * Frame);
                yield return null;
                Assert.That(CentreX(), Is.EqualTo(0.1 + 0.1 * share).Within(1e-5), "a float has steps of a sixteenth here");
            }
        }

        [UnityTest]
        public IEnumerator ItPlaysWithTheGamesTime()
        {
            yield return First;
            WriteDrift(200, Frame);
            Open();
            Playable playable = Add(Clip(start: 10f * Frame));
            graph.SetTimeUpdateMode(DirectorUpdateMode.GameTime);
            graph.Play();
            for (int i = 0; i < 10; i++)
            {
                if (i == 5) // what stops the liquid elsewhere
                {
                    playback.Pause();
                    (simulation.Paused, simulation.TimeScale) = (true, 0f);
                }
                yield return null;
                Assert.That(playback.Time, Is.EqualTo(10f * Frame + (float)playable.GetTime()).Within(1e-6f));
                Assert.That(CentreX(), Is.EqualTo(0.001f * playback.Time / Frame).Within(2e-6f));
            }
            Assert.That(playable.GetTime(), Is.GreaterThan(7.0 * Frame));
        }

        [UnityTest]
        public IEnumerator AFastClipDoesNotJump()
        {
            yield return First;
            WriteDrift(200, Frame);
            Open();
            playback.WaitForFrames = true;
            Playable playable = Add(Clip(speed: 10f));
            ShowAt(playable, 0f);
            yield return null;
            int changes = simulation.Solver.ParticleChanges;
            for (int i = 1; i < 15; i++)
            {
                ShowAt(playable, i * Frame);
                yield return null;
                Assert.That(CentreX(), Is.EqualTo(0.01f * i).Within(2e-6f));
            }
            Assert.That(simulation.Solver.ParticleChanges, Is.EqualTo(changes));
            ShowAt(playable, 3f * Frame);
            yield return null;
            Assert.That(simulation.Solver.ParticleChanges, Is.EqualTo(changes + 1), "back");
        }

        [UnityTest]
        public IEnumerator AClipWithoutAPlaybackIsNamedOnce()
        {
            yield return First;
            WriteDrift(9, Frame);
            Open();
            var lines = new List<string>();
            Application.LogCallback listen = (line, _, type) => lines.Add($"{type}: {line}");
            Application.logMessageReceived += listen;
            try
            {
                FluidPlaybackClip clip = Clip();
                table.ClearReferenceValue("Playback");
                LogAssert.Expect(LogType.Warning, new Regex("'Wave'.*Timeline of 'Director' has no Fluid Playback.*set Playback"));
                Playable playable = Add(clip);
                graph.Play();
                for (int i = 0; i < 4; i++)
                {
                    ShowAt(playable, i * Frame);
                    yield return null;
                }
                playable.Pause();
                graph.Evaluate();
                graph.Destroy();
            }
            finally
            {
                Application.logMessageReceived -= listen;
            }
            Assert.That(lines, Has.Exactly(1).Contains("'Wave'"));
            Assert.That(playback.Clock, Is.EqualTo(FluidPlaybackClock.SceneTime));
        }

        [UnityTest]
        public IEnumerator TheDefaultOfTheReferenceCountsWhereTheTableHasNone()
        {
            yield return First;
            WriteDrift(9, Frame);
            Open();
            FluidPlaybackClip clip = Clip();
            table.ClearReferenceValue("Playback");
            clip.Playback = new ExposedReference<FluidPlayback> { exposedName = "Playback", defaultValue = playback };
            ShowAt(Add(clip), 3f * Frame);
            Assert.That(playback.Time, Is.EqualTo(3f * Frame));
        }

        [UnityTest]
        public IEnumerator ItLastsAsLongAsWhatItShows()
        {
            yield return First;
            WriteDrift(9, Frame);
            Open();
            FluidPlaybackClip clip = Clip();
            Assert.That(clip.duration, Is.EqualTo(5.0), "before a graph is made");
            Add(clip);
            Assert.That(clip.duration, Is.EqualTo(5.0), "before the sequence is open");
            (clip.Start, clip.Speed) = (3f * Frame, -1f);
            Assert.That(clip.duration, Is.EqualTo(5.0), "backwards");
            yield return null;
            foreach ((float start, float speed, double expected) in new[] { (0f, 1f, 8.0), (0f, 2f, 4.0), (2f, 0.5f, 12.0), (8f, -2f, 4.0),
                (3f, -1f, 3.0) })
            {
                (clip.Start, clip.Speed) = (start * Frame, speed);
                Assert.That(clip.duration, Is.EqualTo(expected * Frame).Within(1e-9), $"{start}, {speed}");
            }
            foreach ((float start, float speed) in new[] { (0f, 0f), (8f, 1f), (100f, 1f), (0f, -1f) })
            {
                (clip.Start, clip.Speed) = (start * Frame, speed);
                Assert.That(clip.duration, Is.EqualTo(5.0), $"{start}, {speed}");
            }
        }

        [UnityTest]
        public IEnumerator AFrameOfTheClipMakesNoGarbage()
        {
            yield return First;
            WriteDrift(9, Frame);
            Open();
            Playable playable = Add(Clip());
            ShowAt(playable, Frame);
            FluidPlaybackBehaviour behaviour = ((ScriptPlayable<FluidPlaybackBehaviour>)playable).GetBehaviour();
            long least = long.MaxValue;
            for (int i = 0; i < 20; i++)
            {
                long before = GC.GetAllocatedBytesForCurrentThread();
                behaviour.PrepareFrame(playable, default);
                least = Math.Min(least, GC.GetAllocatedBytesForCurrentThread() - before);
            }
            Assert.That(least, Is.Zero);
        }
    }
}
