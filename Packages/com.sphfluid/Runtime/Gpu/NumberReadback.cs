using System;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Brings a few numbers of a buffer to the CPU without waiting for the GPU, or with.</summary>
    internal sealed class NumberReadback : IDisposable
    {
        private readonly uint[] values;
        private readonly Action<AsyncGPUReadbackRequest> received;
        private readonly Action<uint[]> taken;
        private bool disposed;

        /// <summary>Requested read-backs that have arrived or failed.</summary>
        public long Received { get; private set; }

        /// <param name="count">Numbers that the buffers have.</param>
        /// <param name="taken">Called with the numbers of each read-back, oldest first; the array is used again.</param>
        public NumberReadback(int count, Action<uint[]> taken)
        {
            values = new uint[count];
            received = Receive;
            this.taken = taken;
        }

        /// <summary>Records the read-back; devices without asynchronous read-back use <see cref="ReadNow"/>.</summary>
        public void RecordRequest(CommandBuffer cmd, GraphicsBuffer buffer)
        {
            if (SystemInfo.supportsAsyncGPUReadback) cmd.RequestAsyncReadback(buffer, received);
        }

        /// <summary>Waits for the GPU.</summary>
        public void ReadNow(GraphicsBuffer buffer)
        {
            buffer.GetData(values);
            taken(values);
        }

        /// <summary>Read-backs that have not arrived are dropped.</summary>
        public void Dispose()
        {
            disposed = true;
        }

        private void Receive(AsyncGPUReadbackRequest request)
        {
            Received++;
            if (!disposed && !request.hasError)
            {
                NativeArray<uint> read = request.GetData<uint>();
                read.CopyTo(values);
                taken(values);
            }
        }
    }
}
