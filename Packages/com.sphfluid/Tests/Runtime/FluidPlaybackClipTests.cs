using System;
using System.Collections;
using System.Collections.Generic;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Playables;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>A clip in a graph of playables, as a Timeline makes one: whose time it sets, and whose clock it has for how long.</summary>
    public sealed class FluidPlaybackClipTests : PlaybackTest
    {
        readonly List<Object> made = new List<Object>();
        PlayableGraph graph;
        Table table;

        [SetUp]
        public void MakeGraph()
        {
            graph = PlayableGraph.Create("Timeline");
            graph.SetTimeUpdateMode(DirectorUpdateMode.Manual);
            table = rig.NewObject("Director").AddComponent<Table>();
            graph.SetResolver(table);
        }

        [TearDown]
        public void DestroyGraph()
        {
            if (graph.IsValid()) graph.Destroy();
            foreach (Object clip in made) Object.DestroyImmediate(clip);
            made.Clear();
        }

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
            foreach ((float start, float speed, float time, float expected) in new[] { (2f, 1f, 3f, 5f), (2f, 0.5f, 4f, 4f), (8f, -1f, 2f, 6f), (8f, -2f, 3f, 2f), (3f, 0f, 5f, 3f), (1f, -1f, 4f, 0f) })
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
            files.Write(new[] { 0.0, 8192.0, 8192.0 + Frame }, i => new[] { new FluidParticle(new Vector3(0.1f * i, 0f, 0f), new Vector3(0.1f / Frame, 0f, 0f), 5u) },
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
        public IEnumerator TheClockIsTakenWhileTheClipPlaysAndThenReturned([Values] FluidPlaybackClock clock)
        {
            yield return First;
            WriteDrift(200, Frame);
            Open();
            playback.Clock = clock;
            Playable playable = Add(Clip());
            playable.Pause();
            graph.Play();
            graph.Evaluate();
            Assert.That(playback.Clock, Is.EqualTo(clock), "before the clip");
            for (int round = 0; round < 2; round++)
            {
                playable.Play();
                ShowAt(playable, 50f * Frame);
                Assert.That(playback.Clock, Is.EqualTo(FluidPlaybackClock.Manual));
                yield return null;
                graph.Evaluate();
                yield return null;
                Assert.That(CentreX(), Is.EqualTo(0.05f).Within(2e-6f), "the scene's time does nothing");
                Assert.That(playback.IsPlaying, Is.False);
                playable.Pause();
                graph.Evaluate();
                Assert.That(playback.Clock, Is.EqualTo(clock));
                graph.Evaluate();
                Assert.That(playback.Clock, Is.EqualTo(clock));
            }
            for (int i = 0; i < 3; i++) yield return null;
            if (clock == FluidPlaybackClock.Manual) Assert.That(CentreX(), Is.EqualTo(0.05f).Within(2e-6f), "the last frame of the clip stays");
            else Assert.That(CentreX(), Is.GreaterThan(0.0515f), "it plays on");
            graph.Destroy();
            Assert.That(playback.Clock, Is.EqualTo(clock));
            MakeGraph();
            playable = Add(Clip());
            ShowAt(playable, 60f * Frame);
            Assert.That((playback.Clock, playback.Time), Is.EqualTo((FluidPlaybackClock.Manual, 60f * Frame)), "in another graph");
        }

        [UnityTest]
        public IEnumerator AClockThatIsSetMeanwhileCountsAfterwards()
        {
            yield return First;
            WriteDrift(9, Frame);
            Open();
            Playable playable = Add(Clip());
            ShowAt(playable, 0f);
            playback.Clock = FluidPlaybackClock.Manual;
            Assert.That(playback.Clock, Is.EqualTo(FluidPlaybackClock.Manual));
            playback.Clock = FluidPlaybackClock.SceneTime;
            Assert.That(playback.Clock, Is.EqualTo(FluidPlaybackClock.Manual), "the clip has it");
            playback.Clock = FluidPlaybackClock.Manual;
            graph.Destroy();
            Assert.That(playback.Clock, Is.EqualTo(FluidPlaybackClock.Manual));
        }

        [UnityTest]
        public IEnumerator WhileTheGraphIsPausedTheLiquidStandsStillAndCanBeScrubbed()
        {
            yield return First;
            WriteDrift(200, Frame);
            Open();
            Playable playable = Add(Clip());
            graph.Play();
            ShowAt(playable, 20f * Frame);
            yield return null;
            graph.Stop();
            for (int i = 0; i < 3; i++) yield return null;
            Assert.That(CentreX(), Is.EqualTo(0.02f).Within(2e-6f));
            Assert.That(playback.Clock, Is.EqualTo(FluidPlaybackClock.Manual));
            ShowAt(playable, 30f * Frame);
            yield return null;
            Assert.That(CentreX(), Is.EqualTo(0.03f).Within(2e-6f));
            Assert.That(playback.Clock, Is.EqualTo(FluidPlaybackClock.Manual));
            graph.Play();
            ShowAt(playable, 40f * Frame);
            yield return null;
            Assert.That(CentreX(), Is.EqualTo(0.04f).Within(2e-6f));
            graph.Destroy();
            Assert.That(playback.Clock, Is.EqualTo(FluidPlaybackClock.SceneTime));
        }

        [UnityTest]
        public IEnumerator AGraphThatIsDestroyedReturnsTheClock()
        {
            yield return First;
            WriteDrift(200, Frame);
            Open();
            ShowAt(Add(Clip()), 20f * Frame);
            yield return null;
            graph.Destroy();
            Assert.That(playback.Clock, Is.EqualTo(FluidPlaybackClock.SceneTime));
            float shown = CentreX();
            yield return null;
            yield return null;
            Assert.That(CentreX(), Is.GreaterThan(shown));
        }

        [UnityTest]
        public IEnumerator APlaybackThatIsDestroyedLeavesTheGraphAlone()
        {
            yield return First;
            WriteDrift(9, Frame);
            Open();
            rig.AddVolume(simulation);
            FluidPlaybackClip clip = Clip();
            Playable playable = Add(clip);
            graph.Play();
            ShowAt(playable, Frame);
            yield return null;
            Object.Destroy(playback);
            yield return null;
            ShowAt(playable, 2f * Frame);
            playable.Pause();
            graph.Evaluate();
            playable.Play();
            graph.Evaluate();
            Assert.That(clip.duration, Is.EqualTo(5.0));
            graph.Destroy();
        }

        [UnityTest]
        public IEnumerator OfClipsThatOverlapOneSetsTheTimeAndTheLastReturnsTheClock()
        {
            yield return First;
            WriteDrift(200, Frame);
            Open();
            Playable first = Add(Clip()), second = Add(Clip(start: 100f * Frame));
            first.SetTime(10f * Frame);
            ShowAt(second, 10f * Frame);
            Assert.That(playback.Time, Is.EqualTo(10f * Frame).Or.EqualTo(110f * Frame));
            first.Pause();
            ShowAt(second, 20f * Frame);
            Assert.That((playback.Time, playback.Clock), Is.EqualTo((120f * Frame, FluidPlaybackClock.Manual)));
            first.Play();
            ShowAt(first, 30f * Frame);
            second.Pause();
            ShowAt(first, 40f * Frame);
            Assert.That((playback.Time, playback.Clock), Is.EqualTo((40f * Frame, FluidPlaybackClock.Manual)));
            first.Pause();
            graph.Evaluate();
            Assert.That(playback.Clock, Is.EqualTo(FluidPlaybackClock.SceneTime));
        }

        [UnityTest]
        public IEnumerator ATracksClipsFollowEachOther()
        {
            yield return First;
            WriteDrift(9, Frame);
            Open();
            playback.Clock = FluidPlaybackClock.Manual;
            ScriptPlayable<Track> track = ScriptPlayable<Track>.Create(graph);
            Place(track, Clip(), 1f, 5f);
            Place(track, Clip(start: 8f * Frame, speed: -1f), 7f, 9f);
            Show(track);
            graph.Play();
            foreach ((float time, float shown) in new[] { (0f, 0f), (1f, 0f), (2.5f, 1.5f), (4.75f, 3.75f), (6f, 4f), (7f, 8f), (8.5f, 6.5f), (10f, 6f), (3f, 2f), (8f, 7f), (4f, 3f), (0f, 3f) })
            {
                ShowAt(track, time * Frame);
                yield return null;
                Assert.That(CentreX(), Is.EqualTo(0.01f * shown).Within(2e-6f), $"{time}");
            }
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
            foreach ((float start, float speed, double expected) in new[] { (0f, 1f, 8.0), (0f, 2f, 4.0), (2f, 0.5f, 12.0), (8f, -2f, 4.0), (3f, -1f, 3.0) })
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

        FluidPlaybackClip Clip(float start = 0f, float speed = 1f)
        {
            FluidPlaybackClip clip = ScriptableObject.CreateInstance<FluidPlaybackClip>();
            made.Add(clip);
            clip.name = "Wave";
            (clip.Start, clip.Speed) = (start, speed);
            clip.Playback = new ExposedReference<FluidPlayback> { exposedName = "Playback" };
            table.SetReferenceValue("Playback", playback);
            return clip;
        }

        // On an output of its own.
        Playable Add(FluidPlaybackClip clip)
        {
            Playable playable = clip.CreatePlayable(graph, table.gameObject);
            Show(playable);
            return playable;
        }

        void Show<T>(T playable) where T : struct, IPlayable => ScriptPlayableOutput.Create(graph, "Track").SetSourcePlayable(playable);

        void ShowAt<T>(T playable, double time) where T : struct, IPlayable
        {
            playable.SetTime(time);
            graph.Evaluate();
        }

        // From one frame to another.
        void Place(ScriptPlayable<Track> track, FluidPlaybackClip clip, float from, float to)
        {
            Playable playable = clip.CreatePlayable(graph, table.gameObject);
            playable.Pause();
            track.AddInput(playable, 0);
            track.GetBehaviour().Ranges.Add((from * Frame, to * Frame));
        }

        // What a scene's references are to a Timeline.
        sealed class Table : MonoBehaviour, IExposedPropertyTable
        {
            readonly Dictionary<PropertyName, Object> values = new Dictionary<PropertyName, Object>();

            public void SetReferenceValue(PropertyName id, Object value) => values[id] = value;

            public Object GetReferenceValue(PropertyName id, out bool idValid)
            {
                idValid = values.TryGetValue(id, out Object value);
                return value;
            }

            public void ClearReferenceValue(PropertyName id) => values.Remove(id);
        }

        // Plays, places and pauses its clips before they are prepared, as a Timeline does.
        sealed class Track : PlayableBehaviour
        {
            public List<(double From, double To)> Ranges { get; } = new List<(double From, double To)>();

            public override void PrepareFrame(Playable playable, FrameData info)
            {
                double now = playable.GetTime();
                for (int i = 0; i < Ranges.Count; i++)
                {
                    Playable clip = playable.GetInput(i);
                    bool isInside = now >= Ranges[i].From && now < Ranges[i].To, isPlaying = clip.GetPlayState() == PlayState.Playing;
                    if (isInside && !isPlaying) clip.Play();
                    if (isInside || isPlaying && now >= Ranges[i].To) clip.SetTime(Math.Min(now, Ranges[i].To) - Ranges[i].From);
                    if (!isInside && isPlaying) clip.Pause();
                    playable.SetInputWeight(i, isInside ? 1f : 0f);
                }
            }
        }
    }
}
