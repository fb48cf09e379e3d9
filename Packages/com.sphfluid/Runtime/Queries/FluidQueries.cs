using System;
using System.Collections.Generic;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace SphFluid
{
    /// <summary>
    /// Questions to a liquid that the GPU answers without a stall: all of a frame in one dispatch and one read-back, whose answers come some
    /// frames later. Requests stay until they are removed and are answered again each frame; they outlive a new start, their answers do not.
    /// </summary>
    public sealed class FluidQueries : IDisposable
    {
        const int Readbacks = 4, MostUnderWay = 3, FirstCapacity = 1024;

        struct PointQuery
        {
            public Vector3 Place;
            public uint Generation; // 0: removed
        }

        readonly Object owner;
        readonly Action<FluidMessage> report;
        readonly Stack<int> free = new Stack<int>();
        readonly QueryReadback[] readbacks = new QueryReadback[Readbacks];
        PointQuery[] points = new PointQuery[0];
        int used;
        uint lastGeneration;
        bool changed, disposed;
        FluidSolver solver;
        AnswerPointsPass pass;
        CommandBuffer commands;
        GraphicsBuffer queries, results;
        QueryReadback current;
        long number;
        int run;
        double now;

        internal FluidQueries(Object owner, Action<FluidMessage> report)
        {
            this.owner = owner;
            this.report = report;
            for (int i = 0; i < Readbacks; i++) readbacks[i] = new QueryReadback(Take);
        }

        /// <summary>Raised on the main thread when answers have arrived.</summary>
        public event Action<FluidQueries> Received;

        /// <summary>Number of requests.</summary>
        public int Count => used - free.Count;

        /// <summary>GPU memory [bytes].</summary>
        public long GpuBytes => GpuBuffers.Size(queries, results);

        /// <summary>Frames since the state that the present answers are of; -1 while there are none.</summary>
        public int AgeInFrames => current == null ? -1 : Time.frameCount - current.Frame;

        /// <summary>Simulated time since the state that the present answers are of [s]; -1 while there are none.</summary>
        public double AgeInSeconds => current == null ? -1.0 : now - current.Time;

        /// <summary>Simulated time of the state that the present answers are of [s]; -1 while there are none.</summary>
        public double AnsweredTime => current == null ? -1.0 : current.Time;

        /// <summary>Number of the request that the present answers are of; 0 while there are none.</summary>
        internal long Answer => current?.Number ?? 0;

        /// <summary>All present answers, by <see cref="FluidQuery.Index"/>, for jobs that end within the frame; empty while there are none. Only <see cref="TryGet"/> knows whose they are.</summary>
        public NativeArray<FluidPointResult>.ReadOnly Points => current == null ? default : current.Values.GetSubArray(0, current.Count).AsReadOnly();

        /// <summary>Asks what the liquid is at a point.</summary>
        /// <param name="world">World position [m].</param>
        /// <returns>The request.</returns>
        /// <exception cref="ArgumentException">The position is not finite.</exception>
        public FluidQuery AddPoint(Vector3 world)
        {
            Check(world, nameof(world));
            if (free.Count == 0 && used == points.Length) Array.Resize(ref points, Math.Max(FirstCapacity, 2 * used));
            int index = free.Count > 0 ? free.Pop() : used++;
            lastGeneration = Math.Max(1, unchecked(lastGeneration + 1));
            points[index] = new PointQuery { Place = world, Generation = lastGeneration };
            changed = true;
            return new FluidQuery(index, lastGeneration);
        }

        /// <summary>Asks at another place from now on. Until the answer of that place arrives, that of the last one stays.</summary>
        /// <param name="query">The request.</param>
        /// <param name="world">World position [m].</param>
        /// <exception cref="ArgumentException">The position is not finite, or the request was removed.</exception>
        public void Move(FluidQuery query, Vector3 world)
        {
            Check(world, nameof(world));
            if (!IsAlive(query)) throw new ArgumentException("The query was removed or is none. Add it first.", nameof(query));
            changed |= !points[query.Index].Place.Equals(world);
            points[query.Index].Place = world;
        }

        /// <summary>Ends a request; one that is none or was removed before is left as it is.</summary>
        /// <param name="query">The request.</param>
        public void Remove(FluidQuery query)
        {
            if (!IsAlive(query)) return;
            points[query.Index] = default;
            free.Push(query.Index);
            changed = true;
        }

        /// <summary>The latest answer to a request.</summary>
        /// <param name="query">The request.</param>
        /// <param name="result">The answer, a copy.</param>
        /// <returns>False until the first answer, for removed requests, and while the liquid does not run.</returns>
        public bool TryGet(FluidQuery query, out FluidPointResult result)
        {
            result = default;
            if (current == null || !IsAlive(query) || query.Index >= current.Count) return false;
            FluidPointResult found = current.Values[query.Index];
            if (found.Generation != query.Generation) return false;
            result = found;
            return true;
        }

        /// <summary>Waits for the answers that are under way; for tools and tests.</summary>
        public void Complete()
        {
            for (long n = number - Readbacks + 1; n <= number; n++)
                foreach (QueryReadback readback in readbacks)
                    if (readback.Number == n) readback.Wait();
        }

        /// <summary>Frees all memory; no request is answered after that.</summary>
        public void Dispose()
        {
            Detach();
            disposed = true;
            foreach (QueryReadback readback in readbacks) readback.Dispose();
            commands?.Dispose();
            commands = null;
        }

        /// <summary>Records this frame's questions; nothing where there are none.</summary>
        internal void Ask(FluidSolver liquid, FluidShaderSet shaders, double time, Vector3 position, Quaternion rotation)
        {
            now = time;
            if (Count == 0 || disposed) return;
            if (liquid != solver) Attach(liquid, shaders);
            if (pass == null) return;
            QueryReadback readback = FreeReadback();
            if (readback == null) return;
            Reserve();
            if (changed) queries.SetData(points, 0, 0, used);
            changed = false;
            commands.Clear();
            liquid.RecordNeighbourSetup(commands);
            pass.Record(commands, liquid, position, rotation, queries, results, used);
            Graphics.ExecuteCommandBuffer(commands);
            readback.Request(results, used, ++number, run, time);
        }

        /// <summary>The liquid is gone: its answers too, and the GPU memory.</summary>
        internal void Detach()
        {
            solver = null;
            current = null;
            run++;
            GpuBuffers.Dispose(ref queries);
            GpuBuffers.Dispose(ref results);
        }

        static void Check(Vector3 world, string name)
        {
            float sum = world.x + world.y + world.z;
            if (float.IsNaN(sum) || float.IsInfinity(sum))
                throw new ArgumentException($"The position {world} of a fluid query is not finite. Give a position in metres.", name);
        }

        bool IsAlive(FluidQuery query) => query.Generation != 0 && query.Index < used && points[query.Index].Generation == query.Generation;

        // A liquid whose device or shaders cannot answer is not asked again; the next start is.
        void Attach(FluidSolver liquid, FluidShaderSet shaders)
        {
            Detach();
            solver = liquid;
            pass = null;
            try
            {
                if (!SystemInfo.supportsAsyncGPUReadback) throw new FluidDeviceException($"{SystemInfo.graphicsDeviceName} has no asynchronous readback.");
                pass = new AnswerPointsPass(shaders);
                commands ??= new CommandBuffer { name = "Fluid Queries" };
            }
            catch (FluidDeviceException exception)
            {
                report(new FluidMessage(FluidSeverity.Warning, FluidIssue.QueriesUnavailable, owner, "Fluid queries are not answered: " + exception.Message,
                    "Use the package's shader set and a device that can read back without waiting."));
            }
        }

        QueryReadback FreeReadback()
        {
            QueryReadback found = null;
            int underWay = 0;
            foreach (QueryReadback readback in readbacks)
            {
                underWay += readback.UnderWay ? 1 : 0;
                if (readback.IsFree && readback != current) found = readback;
            }
            return underWay < MostUnderWay ? found : null;
        }

        void Reserve()
        {
            if (queries != null && queries.count >= points.Length) return;
            if (queries != null) solver.State.Retired.Add(queries);
            if (results != null) solver.State.Retired.Add(results);
            queries = GpuBuffers.Create("PointQueries", points.Length, 16);
            results = GpuBuffers.Create("PointResults", points.Length, FluidPointResult.Stride);
            changed = true;
        }

        void Take(QueryReadback arrived)
        {
            if (arrived.Run != run || current != null && current.Number > arrived.Number) return;
            current = arrived;
            Received?.Invoke(this);
        }
    }
}
