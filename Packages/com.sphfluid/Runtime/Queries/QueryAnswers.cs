using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Has a liquid answer the questions of each frame, and keeps the newest answers: a few read-backs that are used again and again.
    /// </summary>
    internal sealed class QueryAnswers : IDisposable
    {
        private const int Readbacks = 4, MostUnderWay = 3;

        private readonly QuerySet asked;
        private readonly Action received;
        private readonly int[] ranges = new int[QueryKind.All.Count + 1];
        private readonly QueryReadback[] readbacks = new QueryReadback[Readbacks];
        private FluidSolver solver;
        private QueryPasses passes;
        private CommandBuffer commands;
        private GraphicsBuffer results;
        private long number;
        private int run;

        /// <param name="asked">The questions.</param>
        /// <param name="received">Called on the main thread when newer answers have arrived.</param>
        public QueryAnswers(QuerySet asked, Action received)
        {
            this.asked = asked;
            this.received = received;
            for (int i = 0; i < Readbacks; i++) readbacks[i] = new QueryReadback(Receive);
        }

        /// <summary>The newest answers; null while there are none.</summary>
        public QueryReadback Current { get; private set; }

        /// <summary>GPU memory of the answers [bytes].</summary>
        public long GpuBytes => GpuBuffers.Size(results) + (passes?.GpuBytes ?? 0);

        /// <summary>Whether a liquid is asked, or was tried to be.</summary>
        public bool IsOf(FluidSolver liquid) => liquid == solver;

        /// <summary>From now on another liquid is asked; one whose device or shaders cannot answer is not.</summary>
        /// <exception cref="FluidDeviceException">The device or the shaders cannot answer.</exception>
        public void Attach(FluidSolver liquid, FluidShaderSet shaders)
        {
            Detach();
            solver = liquid;
            if (!SystemInfo.supportsAsyncGPUReadback)
            {
                throw new FluidDeviceException($"{SystemInfo.graphicsDeviceName} has no asynchronous readback.");
            }
            passes = new QueryPasses(shaders);
            commands ??= new CommandBuffer { name = "Fluid Queries" };
        }

        /// <summary>The liquid is gone: its answers too, and the GPU memory.</summary>
        public void Detach()
        {
            solver = null;
            Current = null;
            run++;
            asked.Free();
            passes?.Dispose();
            passes = null;
            GpuBuffers.Dispose(ref results);
        }

        /// <summary>Asks the liquid this frame's questions; not where it cannot answer, or enough answers are under way.</summary>
        /// <param name="time">Its simulated time [s].</param>
        /// <param name="position">World position of simulation space's origin [m].</param>
        /// <param name="rotation">World rotation of simulation space.</param>
        public void Ask(double time, Vector3 position, Quaternion rotation)
        {
            if (passes == null) return;
            QueryReadback readback = FreeReadback();
            if (readback == null) return;
            Reserve();
            asked.CopyRanges(ranges);
            commands.Clear();
            solver.RecordNeighbourSetup(commands);
            passes.Record(commands, new QueryTarget { Solver = solver, Position = position, Rotation = rotation, Results = results },
                asked, ranges);
            Graphics.ExecuteCommandBuffer(commands);
            readback.Request(results, ranges, ++number, run, time);
        }

        /// <summary>Waits for the answers that are under way, in the order in which they were asked for.</summary>
        public void Complete()
        {
            for (long n = number - Readbacks + 1; n <= number; n++)
                foreach (QueryReadback readback in readbacks)
                    if (readback.Number == n) readback.Wait();
        }

        public void Dispose()
        {
            Detach();
            foreach (QueryReadback readback in readbacks) readback.Dispose();
            commands?.Dispose();
            commands = null;
        }

        private QueryReadback FreeReadback()
        {
            QueryReadback found = null;
            int underWay = 0;
            foreach (QueryReadback readback in readbacks)
            {
                underWay += readback.UnderWay ? 1 : 0;
                if (readback.IsFree && readback != Current) found = readback;
            }
            return underWay < MostUnderWay ? found : null;
        }

        private void Reserve()
        {
            RetiredBuffers retired = solver.State.Retired;
            asked.Upload(retired);
            int capacity = asked.Capacity;
            if (results != null && results.count >= capacity) return;
            if (results != null) retired.Add(results);
            results = GpuBuffers.Create("Fluid Query Results", capacity, QueryReadback.Stride);
        }

        private void Receive(QueryReadback arrived)
        {
            if (arrived.Run != run || Current != null && Current.Number > arrived.Number) return;
            Current = arrived;
            received();
        }
    }
}
