using System;
using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Playables;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>Which clip has the clock of a playback, for how long, and who has it afterwards.</summary>
    public sealed class FluidPlaybackClipClockTests : PlaybackClipTest
    {
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
            if (clock == FluidPlaybackClock.Manual) Assert.That(CentreX(), Is.EqualTo(0.05f).Within(2e-6f),
                "the last frame of the clip stays");
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
            foreach ((float time, float shown) in new[] { (0f, 0f), (1f, 0f), (2.5f, 1.5f), (4.75f, 3.75f), (6f, 4f), (7f, 8f),
                (8.5f, 6.5f), (10f, 6f), (3f, 2f), (8f, 7f), (4f, 3f), (0f, 3f) })
            {
                ShowAt(track, time * Frame);
                yield return null;
                Assert.That(CentreX(), Is.EqualTo(0.01f * shown).Within(2e-6f), $"{time}");
            }
        }

        // From one frame to another.
        private void Place(ScriptPlayable<Track> track, FluidPlaybackClip clip, float from, float to)
        {
            Playable playable = clip.CreatePlayable(graph, table.gameObject);
            playable.Pause();
            track.AddInput(playable, 0);
            track.GetBehaviour().Ranges.Add((from * Frame, to * Frame));
        }

        // Plays, places and pauses its clips before they are prepared, as a Timeline does.
        private sealed class Track : PlayableBehaviour
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
