using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// What the flow through rectangles needs from look to look: their sums, where they were, and where the particles were.
    /// </summary>
    internal sealed class PatchSums : IDisposable
    {
        /// <summary>Places of particles, found by their ids.</summary>
        internal sealed class Table
        {
            private GraphicsBuffer keys, places;

            /// <summary>Ids plus one; 0: empty.</summary>
            public GraphicsBuffer Keys => keys;

            public GraphicsBuffer Places => places;

            /// <summary>A power of two.</summary>
            public int Length => keys.count;

            public long GpuBytes => GpuBuffers.Size(keys, places);

            /// <summary>Makes an empty table where there is none or a shorter one.</summary>
            public void Reserve(int length, RetiredBuffers retired)
            {
                if (keys != null && Length >= length) return;
                if (keys != null) retired.Add(keys);
                if (places != null) retired.Add(places);
                keys = GpuBuffers.Create("Fluid Patch Keys", length, sizeof(uint));
                keys.SetData(new uint[length]);
                places = GpuBuffers.Create("Fluid Patch Places", length, 16);
            }

            public void Dispose()
            {
                GpuBuffers.Dispose(ref keys);
                GpuBuffers.Dispose(ref places);
            }
        }

        private GraphicsBuffer patches, sums;

        /// <summary>The rectangles at the look before.</summary>
        public GraphicsBuffer Patches => patches;

        /// <summary>Two numbers a rectangle.</summary>
        public GraphicsBuffer Sums => sums;

        /// <summary>The particles at the look before.</summary>
        public Table Before { get; private set; } = new Table();

        /// <summary>The particles at this look.</summary>
        public Table Now { get; private set; } = new Table();

        /// <summary>Bytes of GPU memory.</summary>
        public long GpuBytes => GpuBuffers.Size(patches, sums) + Before.GpuBytes + Now.GpuBytes;

        /// <summary>Makes place; what is there stays.</summary>
        /// <param name="capacity">Number of rectangles.</param>
        /// <param name="particles">Number of particles.</param>
        /// <param name="retired">Takes buffers that are replaced.</param>
        public void Reserve(int capacity, int particles, RetiredBuffers retired)
        {
            Grow<QueryWord>(ref patches, "Fluid Patches Before", AnswerPatchesPass.Words * capacity, QueryWord.Stride, retired);
            Grow<uint>(ref sums, "Fluid Patch Sums", 2 * capacity, sizeof(uint), retired);
            Before.Reserve(2, retired);
            Now.Reserve(Mathf.NextPowerOfTwo(Math.Max(2, 2 * particles)), retired);
        }

        /// <summary>A look is over.</summary>
        public void Swap() => (Before, Now) = (Now, Before);

        public void Dispose()
        {
            GpuBuffers.Dispose(ref patches);
            GpuBuffers.Dispose(ref sums);
            Before.Dispose();
            Now.Dispose();
        }

        private static void Grow<T>(ref GraphicsBuffer buffer, string name, int count, int stride, RetiredBuffers retired) where T : struct
        {
            if (buffer != null && buffer.count >= count) return;
            var items = new T[count];
            if (buffer != null)
            {
                buffer.GetData(items, 0, 0, buffer.count);
                retired.Add(buffer);
            }
            buffer = GpuBuffers.Create(name, count, stride);
            buffer.SetData(items);
        }
    }
}
