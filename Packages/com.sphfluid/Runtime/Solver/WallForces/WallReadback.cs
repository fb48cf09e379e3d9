using System;
using System.Collections.Generic;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Brings the sums of wall patches to the CPU, batch by batch. Sums whose read-back fails are lost with the time that they were of.
    /// </summary>
    internal sealed class WallReadback : IDisposable
    {
        private readonly Action received;
        private readonly List<Batch> underWay = new List<Batch>(); // oldest first
        private readonly Stack<Batch> free = new Stack<Batch>();
        private bool disposed;

        /// <param name="received">Called when a batch was handed to its patches.</param>
        public WallReadback(Action received)
        {
            this.received = received;
        }

        /// <summary>A batch of steps that is to be recorded.</summary>
        public Batch Begin(IReadOnlyList<WallPatch> patches, int steps, double unit)
        {
            Batch batch = free.Count > 0 ? free.Pop() : new Batch(this);
            batch.Begin(patches, steps, unit);
            return batch;
        }

        /// <summary>Records the read-back of a batch.</summary>
        public void RecordRequest(CommandBuffer cmd, GraphicsBuffer sums, Batch batch)
        {
            underWay.Add(batch);
            batch.Record(cmd, sums);
        }

        /// <summary>Reads what devices without asynchronous read-back have by now.</summary>
        public void TakeReady()
        {
            if (!SystemInfo.supportsAsyncGPUReadback) Wait();
        }

        /// <summary>Waits for all that is under way.</summary>
        public void Wait()
        {
            if (underWay.Count == 0) return;
            if (SystemInfo.supportsAsyncGPUReadback) AsyncGPUReadback.WaitAllRequests();
            else foreach (Batch batch in underWay.ToArray()) batch.ReadNow();
        }

        /// <summary>What has not arrived is dropped.</summary>
        public void Dispose() => disposed = true;

        private void Finish(Batch batch, bool isRead)
        {
            underWay.Remove(batch);
            if (disposed) return;
            if (isRead) batch.Deliver();
            free.Push(batch);
            if (isRead) received();
        }

        /// <summary>The sums of a batch of steps.</summary>
        internal sealed class Batch
        {
            private readonly WallReadback owner;
            private readonly Action<AsyncGPUReadbackRequest> arrived;
            private readonly List<WallPatch> patches = new List<WallPatch>();
            private readonly double[] times = new double[WallForces.MostParts], lengths = new double[WallForces.MostParts];
            private uint[] words = Array.Empty<uint>();
            private GraphicsBuffer sums;
            private int steps, step, parts;

            public Batch(WallReadback owner)
            {
                this.owner = owner;
                arrived = Arrive;
            }

            /// <summary>Unit of the sums [N s].</summary>
            public double Unit { get; private set; }

            /// <summary>Where the sums of the present part begin.</summary>
            public int FirstWord => (parts - 1) * 2 * patches.Count;

            public void Begin(IReadOnlyList<WallPatch> now, int count, double unit)
            {
                patches.Clear();
                patches.AddRange(now);
                (steps, step, parts, Unit) = (count, 0, 0, unit);
            }

            /// <summary>Adds a step.</summary>
            /// <param name="endTime">Simulated time at its end [s].</param>
            /// <param name="length">Over which its forces act [s].</param>
            /// <returns>Whether it is the first of a part.</returns>
            public bool AddStep(double endTime, double length)
            {
                int part = steps <= WallForces.MostParts ? step : (int)((long)step * WallForces.MostParts / steps);
                bool begins = part == parts;
                if (begins) lengths[parts++] = 0.0;
                step++;
                times[part] = endTime;
                lengths[part] += length;
                return begins;
            }

            public void Record(CommandBuffer cmd, GraphicsBuffer buffer)
            {
                int count = parts * 2 * patches.Count;
                if (words.Length < count) words = new uint[Mathf.NextPowerOfTwo(count)];
                sums = buffer;
                if (SystemInfo.supportsAsyncGPUReadback) cmd.RequestAsyncReadback(buffer, count * sizeof(uint), 0, arrived);
            }

            public void ReadNow()
            {
                sums.GetData(words, 0, 0, parts * 2 * patches.Count);
                owner.Finish(this, true);
            }

            public void Deliver()
            {
                for (int part = 0; part < parts; part++)
                {
                    for (int p = 0; p < patches.Count; p++)
                    {
                        int at = 2 * (part * patches.Count + p);
                        long units = unchecked((long)((ulong)words[at + 1] << 32 | words[at]));
                        patches[p].SetSample(new WallSample(times[part], lengths[part], units * Unit));
                    }
                }
            }

            private void Arrive(AsyncGPUReadbackRequest request)
            {
                bool isRead = !request.hasError && !owner.disposed;
                if (isRead) NativeArray<uint>.Copy(request.GetData<uint>(), 0, words, 0, parts * 2 * patches.Count);
                owner.Finish(this, isRead);
            }
        }
    }
}
