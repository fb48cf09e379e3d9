using System;

namespace SphFluid
{
    /// <summary>Where a playback stands in its sequence.</summary>
    internal static class PlaybackTime
    {
        // Nearer to a frame than this part of the way to the next it is that frame, and nearer than a float tells times apart.
        private const double FrameShare = 1e-4, FloatShare = 2.4e-7;

        /// <summary>Time of a round, after which everything is as before [s].</summary>
        public static double Round(double duration, FluidPlaybackLoop loop) => loop == FluidPlaybackLoop.PingPong
            ? 2.0 * duration : duration;

        /// <summary>A time within the first round [s]; where there are no rounds, within the sequence.</summary>
        public static double Wrap(double time, double duration, FluidPlaybackLoop loop)
        {
            if (loop == FluidPlaybackLoop.None || !(duration > 0.0)) return Math.Max(0.0, Math.Min(time, duration));
            double round = Round(duration, loop);
            return time >= 0.0 && time <= round ? time : time - round * Math.Floor(time / round);
        }

        /// <summary>Time since the first frame [s] of a time that may lie past the ends.</summary>
        public static double Fold(double time, double duration, FluidPlaybackLoop loop)
        {
            double wrapped = Wrap(time, duration, loop);
            return wrapped > duration ? 2.0 * duration - wrapped : wrapped;
        }

        /// <summary>The frames around a time.</summary>
        /// <param name="sequence">The sequence.</param>
        /// <param name="time">Time since its first frame [s], within it.</param>
        public static PlaybackPlace Find(ParticleSequence sequence, double time)
        {
            double absolute = sequence.Start + time;
            int frame = sequence.FrameAt(absolute);
            if (frame == sequence.Frames.Count - 1) return new PlaybackPlace(frame, frame, 0.0, sequence.Frames[frame].Time);
            double begin = sequence.Frames[frame].Time, length = sequence.Frames[frame + 1].Time - begin, since = absolute - begin;
            double near = Math.Max(FrameShare * length, FloatShare * Math.Abs(time));
            if (since <= near) return new PlaybackPlace(frame, frame, 0.0, begin);
            if (length - since <= near) return new PlaybackPlace(frame + 1, frame + 1, 0.0, begin + length);
            return new PlaybackPlace(frame, frame + 1, since / length, absolute);
        }
    }

    /// <summary>A place at or between frames.</summary>
    internal readonly struct PlaybackPlace
    {
        public PlaybackPlace(int from, int to, double share, double time)
        {
            From = from;
            To = to;
            Share = share;
            Time = time;
        }

        /// <summary>The frame at it or before it.</summary>
        public int From { get; }

        /// <summary>The frame after it; where it is at a frame, the same.</summary>
        public int To { get; }

        /// <summary>Part of the way from one to the other that is behind it, 0 to 1.</summary>
        public double Share { get; }

        /// <summary>Time of the sequence [s].</summary>
        public double Time { get; }

        /// <summary>The nearer frame.</summary>
        public int Nearer => Share < 0.5 ? From : To;
    }
}
