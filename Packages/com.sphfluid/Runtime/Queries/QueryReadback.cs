using System;
using System.Runtime.InteropServices;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>One of the read-backs of <see cref="FluidQueries"/>, used again and again.</summary>
    internal sealed class QueryReadback
    {
        /// <summary>Bytes of an answer of any kind.</summary>
        public const int Stride = 32;

        [StructLayout(LayoutKind.Sequential, Size = Stride)]
        private struct Answer
        {
        }

        private readonly Action<QueryReadback> arrived;
        private readonly Action<AsyncGPUReadbackRequest> received;
        private AsyncGPUReadbackRequest request;
        private NativeArray<Answer> values;
        private readonly int[] firsts = new int[QueryKind.All.Count + 1];
        private int late;

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

        public void Request(GraphicsBuffer results, int[] ranges, long number, int run, double time)
        {
            int capacity = results.count;
            if (!values.IsCreated || values.Length != capacity)
            {
                Free();
                values = new NativeArray<Answer>(capacity, Allocator.Persistent);
            }
            Array.Copy(ranges, firsts, firsts.Length);
            (Number, Run, Frame, Time) = (number, run, UnityEngine.Time.frameCount, time);
            UnderWay = true;
            request = AsyncGPUReadback.RequestIntoNativeArray(ref values, results, Stride * firsts[firsts.Length - 1], 0, received);
        }

        /// <summary>The answers of a kind, without a copy.</summary>
        public NativeArray<T> GetAnswers<T>(QueryKind kind) where T : struct
        {
            (int first, int count) = Range(kind);
            return values.GetSubArray(first, count).Reinterpret<T>(Stride);
        }

        /// <summary>The answer to a request, if it was asked by then.</summary>
        public bool TryGet<T>(QueryKind kind, int index, out T result) where T : struct
        {
            bool wasAsked = index < Range(kind).count;
            result = wasAsked ? GetAnswers<T>(kind)[index] : default;
            return wasAsked;
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

        private void Receive(AsyncGPUReadbackRequest answer)
        {
            if (late > 0) late--;
            else if (UnderWay) Finish(answer.hasError);
        }

        private void Finish(bool failed)
        {
            UnderWay = false;
            if (!failed) arrived(this);
        }

        private (int first, int count) Range(QueryKind kind) => (firsts[kind.Index], firsts[kind.Index + 1] - firsts[kind.Index]);

        private void Free()
        {
            if (values.IsCreated) values.Dispose();
            values = default;
        }
    }
}
