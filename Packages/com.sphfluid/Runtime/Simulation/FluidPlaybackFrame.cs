using System;
using Unity.Collections;

namespace SphFluid
{
    /// <summary>A moment of a liquid that is played back.</summary>
    public readonly struct FluidPlaybackFrame
    {
        /// <summary>A moment.</summary>
        /// <param name="particles">The particles in its first elements, in simulation space and within the domain; read before the
        /// simulation's next frame.</param>
        /// <param name="count">Number of particles, 0 or more.</param>
        /// <param name="time">Time of the liquid [s].</param>
        /// <param name="isJump">Whether they do not follow from what was shown before, so that whitewater and readings begin anew.</param>
        /// <exception cref="ArgumentException">There are more particles than elements, fewer than none, or the time is not
        /// finite.</exception>
        public FluidPlaybackFrame(NativeArray<FluidParticle> particles, int count, double time, bool isJump)
        {
            if (count < 0 || count > particles.Length)
            {
                throw new ArgumentException(
                    $"The count is {count}. Give it a number from 0 to {particles.Length}, the length of the array.", nameof(count));
            }
            Require.Within(time, double.MinValue, double.MaxValue, nameof(time));
            Particles = particles;
            Count = count;
            Time = time;
            IsJump = isJump;
        }

        /// <summary>The particles, in the first <see cref="Count"/> elements.</summary>
        public NativeArray<FluidParticle> Particles { get; }

        /// <summary>Number of particles.</summary>
        public int Count { get; }

        /// <summary>Time of the liquid [s].</summary>
        public double Time { get; }

        /// <summary>Whether they do not follow from what was shown before.</summary>
        public bool IsJump { get; }
    }
}
