using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>Which frames a time lies between, past the ends too, and which are needed next.</summary>
    public sealed class PlaybackTimeTests
    {
        [TestCase(FluidPlaybackLoop.None, -1.0, 0.0)]
        [TestCase(FluidPlaybackLoop.None, 0.75, 0.75)]
        [TestCase(FluidPlaybackLoop.None, 7.0, 2.0)]
        [TestCase(FluidPlaybackLoop.Repeat, 2.5, 0.5)]
        [TestCase(FluidPlaybackLoop.Repeat, -0.5, 1.5)]
        [TestCase(FluidPlaybackLoop.Repeat, 2.0, 2.0)]
        [TestCase(FluidPlaybackLoop.Repeat, 9.0, 1.0)]
        [TestCase(FluidPlaybackLoop.PingPong, 2.5, 1.5)]
        [TestCase(FluidPlaybackLoop.PingPong, 4.5, 0.5)]
        [TestCase(FluidPlaybackLoop.PingPong, -0.5, 0.5)]
        [TestCase(FluidPlaybackLoop.PingPong, 6.0, 2.0)]
        public void TimesPastTheEndsFollowTheLoop(FluidPlaybackLoop loop, double time, double expected)
        {
            Assert.That(PlaybackTime.Fold(time, 2.0, loop), Is.EqualTo(expected));
            Assert.That(PlaybackTime.Fold(time, 0.0, loop), Is.Zero);
        }

        [Test]
        public void APlaceIsAFrameOrBetweenTwo()
        {
            ParticleSequence sequence = Sequence(5.0, 5.1, 5.25, 6.0);
            Check(0.0, 0, 0, 0.0, 5.0);
            Check(0.05, 0, 1, 0.5, 5.05);
            Check(0.1, 1, 1, 0.0, 5.1);
            Check((float)0.1, 1, 1, 0.0, 5.1);
            Check(0.25 - 1e-6, 2, 2, 0.0, 5.25);
            Check(0.55, 2, 3, 0.4, 5.55);
            Check(1.0, 3, 3, 0.0, 6.0);

            void Check(double time, int from, int to, double share, double at)
            {
                PlaybackPlace place = PlaybackTime.Find(sequence, time);
                Assert.That((place.From, place.To), Is.EqualTo((from, to)), $"{time}");
                Assert.That(place.Share, Is.EqualTo(share).Within(1e-9), $"{time}");
                Assert.That(place.Time, Is.EqualTo(at).Within(1e-12), $"{time}");
            }
        }

        [TestCase(1)]
        [TestCase(2)]
        [TestCase(257)]
        public void EveryFrameIsFoundAtItsTime(int count)
        {
            ParticleSequence sequence = Sequence(Enumerable.Range(0, count).Select(i => i / 60.0).ToArray());
            for (int i = 0; i < count; i++)
            {
                PlaybackPlace place = PlaybackTime.Find(sequence, (float)(i / 60.0));
                Assert.That((place.From, place.To, place.Share, place.Time), Is.EqualTo((i, i, 0.0, i / 60.0)));
                if (i + 1 < count) Assert.That(PlaybackTime.Find(sequence, (i + 0.5) / 60.0).From, Is.EqualTo(i));
            }
        }

        [TestCase(1, 1, 1, FluidPlaybackLoop.None, "1")]
        [TestCase(2, 1, 5, FluidPlaybackLoop.None, "2 3 4")]
        [TestCase(2, -1, 5, FluidPlaybackLoop.None, "2 1 0")]
        [TestCase(3, 1, 5, FluidPlaybackLoop.Repeat, "3 4 0 1 2 3 4 0")]
        [TestCase(1, -1, 5, FluidPlaybackLoop.Repeat, "1 0 4 3 2 1 0 4")]
        [TestCase(3, 1, 5, FluidPlaybackLoop.PingPong, "3 4 3 2 1 0 1 2")]
        [TestCase(1, -1, 5, FluidPlaybackLoop.PingPong, "1 0 1 2 3 4 3 2")]
        [TestCase(0, 1, 2, FluidPlaybackLoop.PingPong, "0 1 0 1 0 1 0 1")]
        [TestCase(0, 1, 1, FluidPlaybackLoop.Repeat, "0")]
        [TestCase(0, -1, 1, FluidPlaybackLoop.PingPong, "0")]
        public void FramesAreNeededInTheOrderOfPlay(int first, int direction, int count, FluidPlaybackLoop loop, string expected)
        {
            var frames = new List<int>();
            var walk = new SequenceWalk(count > first ? first : 0, direction, count, loop);
            do frames.Add(walk.Frame);
            while (frames.Count < 8 && walk.Next());
            Assert.That(string.Join(" ", frames), Is.EqualTo(count > first ? expected : "0"));
        }

        private static ParticleSequence Sequence(params double[] times) =>
            new ParticleSequence("", Array.ConvertAll(times, t => new SequenceFrame("a.ply", t, 1, 1, null)), true, true);
    }
}
