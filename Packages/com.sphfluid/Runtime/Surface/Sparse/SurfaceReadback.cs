using System;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Brings the counters of a sparse surface to the CPU without waiting for the GPU.</summary>
    sealed class SurfaceReadback : IDisposable
    {
        readonly Action<AsyncGPUReadbackRequest> received;
        readonly Action<SurfaceStatus> taken;
        bool disposed;

        /// <param name="taken">Called for each surface that was read back, oldest first.</param>
        public SurfaceReadback(Action<SurfaceStatus> taken)
        {
            this.taken = taken;
            received = Receive;
        }

        /// <summary>Records the read-back; devices without asynchronous read-back use <see cref="ReadNow"/>.</summary>
        public void RecordRequest(CommandBuffer cmd, SurfaceBlocks blocks)
        {
            if (SystemInfo.supportsAsyncGPUReadback)
                cmd.RequestAsyncReadback(blocks.Counters, received);
        }

        /// <summary>Waits for the GPU.</summary>
        public void ReadNow(SurfaceBlocks blocks)
        {
            var values = new uint[SurfaceCounters.Slots];
            blocks.Counters.GetData(values);
            taken(new SurfaceStatus(values));
        }

        public void Dispose() => disposed = true;

        void Receive(AsyncGPUReadbackRequest request)
        {
            if (disposed || request.hasError)
                return;
            NativeArray<uint> values = request.GetData<uint>();
            taken(new SurfaceStatus(values.ToArray()));
        }
    }
}
