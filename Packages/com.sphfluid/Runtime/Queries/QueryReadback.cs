using System;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>One of the read-backs of <see cref="FluidQueries"/>, used again and again.</summary>
    internal sealed class QueryReadback
    {
        readonly Action<QueryReadback> arrived;
        readonly Action<AsyncGPUReadbackRequest> received;
        AsyncGPUReadbackRequest request;
        NativeArray<FluidPointResult> values;
        int late;

        public QueryReadback(Action<QueryReadback> arrived)
        {
            this.arrived = arrived;
            received = Receive;
        }

        public bool UnderWay { get; private set; }
        public bool IsFree => !UnderWay && late == 0;
        public long Number { get; private set; }
        public int Run { get; private set; }
        public int Frame { get; private set; }
        public double Time { get; private set; }
        public int Count { get; private set; }
        public NativeArray<FluidPointResult> Values => values;

        public void Request(GraphicsBuffer results, int count, long number, int run, double time)
        {
            int capacity = results.count;
            if (!values.IsCreated || values.Length != capacity)
            {
                Free();
                values = new NativeArray<FluidPointResult>(capacity, Allocator.Persistent);
            }
            (Number, Run, Frame, Time, Count) = (number, run, UnityEngine.Time.frameCount, time, count);
            UnderWay = true;
            request = AsyncGPUReadback.RequestIntoNativeArray(ref values, results, FluidPointResult.Stride * count, 0, received);
        }

        /// <summary>Waits for the GPU; a callback that comes after that is not taken for the next request's.</summary>
        public void Wait()
        {
            if (!UnderWay) return;
            request.WaitForCompletion();
            if (!UnderWay) return;
            late++;
            Finish(request.hasError);
        }

        public void Dispose()
        {
            if (UnderWay) request.WaitForCompletion();
            UnderWay = false;
            Free();
        }

        void Receive(AsyncGPUReadbackRequest answer)
        {
            if (late > 0) late--;
            else if (UnderWay) Finish(answer.hasError);
        }

        void Finish(bool failed)
        {
            UnderWay = false;
            if (!failed) arrived(this);
        }

        void Free()
        {
            if (values.IsCreated) values.Dispose();
            values = default;
        }
    }
}
