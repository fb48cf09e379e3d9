using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>What each source gave and each drain took, counted on the GPU and known on the CPU a few frames later.</summary>
    internal sealed class SourceCounts : IDisposable
    {
        /// <summary>Most sources and drains of a liquid.</summary>
        public const int Most = 256;

        /// <summary>The source whose first count is of recycled particles.</summary>
        public const int Recycled = 0;

        /// <summary>The source of particles that a script adds.</summary>
        public const int Added = 1;

        /// <summary>The source whose first count is of particles that a script removes.</summary>
        public const int Removed = 2;

        // Born, blocked, refused; of a drain what left, 0, 0.
        private const int Kinds = 3;

        private readonly long[] totals = new long[Kinds * Most];
        private readonly uint[] last = new uint[Kinds * Most];
        private readonly Queue<int> free = new Queue<int>();
        private readonly NumberReadback readback;
        private GraphicsBuffer buffer;

        public SourceCounts()
        {
            for (int i = Removed + 1; i < Most; i++) free.Enqueue(i);
            readback = new NumberReadback(Kinds * Most, Receive);
            buffer = GpuBuffers.Create("Fluid Source Counts", Kinds * Most, sizeof(uint));
            buffer.SetData(new uint[Kinds * Most]);
        }

        /// <summary>The counts on the GPU, three a source.</summary>
        public GraphicsBuffer Buffer => buffer;

        /// <summary>Place of a source's first count.</summary>
        public static int Place(int source) => Kinds * source;

        /// <summary>
        /// Takes a number for a source. Numbers of sources that went are used again as late as possible, when all that they had under way
        /// is counted.
        /// </summary>
        /// <returns>False when all are in use.</returns>
        public bool TryOpen(out int source)
        {
            if (!free.TryDequeue(out source)) return false;
            Array.Clear(totals, Place(source), Kinds);
            return true;
        }

        /// <summary>Gives a source's number back.</summary>
        public void Close(int source) => free.Enqueue(source);

        /// <summary>Particles that the source gave, or the drain took.</summary>
        public long Passed(int source) => totals[Place(source)];

        /// <summary>Particles that were not born because their place was taken.</summary>
        public long Blocked(int source) => totals[Place(source) + 1];

        /// <summary>Particles that were not born because the liquid may have no more.</summary>
        public long Refused(int source) => totals[Place(source) + 2];

        /// <summary>Writes the counts and which numbers are free, once no read-back is under way.</summary>
        public void Save(SaveWriter writer)
        {
            ReadNow();
            writer.WriteItems(totals, totals.Length);
            writer.WriteItems(free.ToArray(), free.Count);
        }

        /// <summary>Goes on from a save: what the GPU counts from now on is added.</summary>
        public void Load(SaveReader reader)
        {
            ReadNow();
            long[] saved = reader.ReadItems<long>();
            Array.Copy(saved, totals, Math.Min(saved.Length, totals.Length));
            free.Clear();
            foreach (int source in reader.ReadItems<int>()) free.Enqueue(source);
        }

        /// <summary>Records the read-back.</summary>
        public void RecordRequest(CommandBuffer cmd) => readback.RecordRequest(cmd, buffer);

        /// <summary>Waits for the GPU and reads the counts.</summary>
        public void ReadNow() => readback.ReadNow(buffer);

        public void Dispose()
        {
            readback.Dispose();
            GpuBuffers.Dispose(ref buffer);
        }

        // The GPU counts modulo 2^32; a read-back older than one that was waited for adds nothing.
        private void Receive(uint[] values)
        {
            for (int i = 0; i < values.Length; i++)
            {
                int added = unchecked((int)(values[i] - last[i]));
                if (added <= 0) continue;
                last[i] = values[i];
                totals[i] += added;
            }
        }
    }
}
