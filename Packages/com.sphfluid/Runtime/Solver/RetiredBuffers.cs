using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>
    /// Buffers that were replaced and that recorded command buffers may still use: they go when the GPU has done what was recorded with
    /// them.
    /// </summary>
    internal sealed class RetiredBuffers : IDisposable
    {
        private readonly Queue<(IDisposable buffer, long frame)> waiting = new Queue<(IDisposable, long)>();
        private long frame;

        /// <summary>Takes a buffer.</summary>
        public void Add(IDisposable buffer) => waiting.Enqueue((buffer, frame));

        /// <summary>A frame's recording ends.</summary>
        /// <returns>Its number, for <see cref="Release"/>.</returns>
        public long EndFrame() => frame++;

        /// <summary>Releases what was taken up to a frame that the GPU has done.</summary>
        public void Release(long done)
        {
            while (waiting.Count > 0 && waiting.Peek().frame <= done) waiting.Dequeue().buffer.Dispose();
        }

        public void Dispose() => Release(long.MaxValue);
    }
}
