using System;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace SphFluid
{
    /// <summary>Memory for one frame that was read ahead. Filled by the thread that reads while nobody else looks at it.</summary>
    internal sealed unsafe class SequenceSlot : IDisposable
    {
        private readonly StoredParticle* memory;
        private NativeArray<StoredParticle> particles;

        /// <param name="capacity">Most particles.</param>
        public SequenceSlot(int capacity)
        {
            particles = new NativeArray<StoredParticle>(Math.Max(1, capacity), Allocator.Persistent,
                NativeArrayOptions.UninitializedMemory);
            memory = (StoredParticle*)NativeArrayUnsafeUtility.GetUnsafePtr(particles);
        }

        /// <summary>The particles; the first <see cref="Count"/> are those of the frame, by ascending numbers.</summary>
        public NativeArray<StoredParticle> Particles => particles;

        /// <summary>Number of particles.</summary>
        public int Count { get; private set; }

        /// <summary>The frame that it holds or is to hold; −1: none.</summary>
        public int Frame { get; set; } = -1;

        /// <summary>Whether the frame is there.</summary>
        public bool IsReady { get; set; }

        /// <summary>Makes place for the particles of a frame, from any thread.</summary>
        /// <param name="count">Their number.</param>
        /// <returns>Where they go.</returns>
        /// <exception cref="SequenceException">There are more than it has place for.</exception>
        public Span<StoredParticle> Resize(long count)
        {
            if (count > particles.Length)
            {
                throw new SequenceException($"has {count} particles, more than any frame had when the folder was opened",
                    "Disable the Fluid Playback and enable it again.");
            }
            Count = (int)count;
            return new Span<StoredParticle>(memory, Count);
        }

        public void Dispose() => particles.Dispose();
    }
}
