using System;
using System.Collections;
using System.Collections.Generic;
using SphFluid.Laboratory;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>Records frames of the benchmark and measures them. All waiting is by yielding a frame of the engine.</summary>
    internal sealed class BenchSampler : IDisposable
    {
        // One submission: bounded so that no driver takes it for a hang.
        private const int MostFramesAtOnce = 128;
        private const double SubmissionMilliseconds = 500.0;
        private const int EngineFramesToWait = 200;
        private const int MostTrials = 16;

        private static readonly ProfilerMarker frameMarker = GpuLaboratory.CreateMarker(FrameBlocks.Frame);

        private readonly FluidShaderSet shaders;
        private readonly Dictionary<BenchConfig, IBenchSurface> surfaces = new Dictionary<BenchConfig, IBenchSurface>();
        private readonly GpuClock clock;
        private readonly CommandBuffer cmd = new CommandBuffer { name = "Fluid Benchmark" };
        private readonly BenchDrawing drawing;

        public BenchSampler(FluidShaderSet shaders, IReadOnlyList<BenchBlock> blocks, Vector2Int pictureSize)
        {
            this.shaders = shaders;
            clock = new GpuClock(blocks);
            drawing = new BenchDrawing(shaders, pictureSize);
        }

        /// <summary>Least GPU time of a sample [ms].</summary>
        public double SampleMilliseconds { get; set; }

        /// <summary>Whether the passes inside a frame are timed too, which takes time itself; false at first.</summary>
        public bool TimesPasses
        {
            get => clock.TimesPasses;
            set => clock.TimesPasses = value;
        }

        /// <summary>Times of the last sample or submission.</summary>
        public BenchTimes Last { get; private set; }

        /// <summary>Compute dispatches of a frame of the last sample.</summary>
        public long Dispatches { get; private set; }

        /// <summary>Time of the neighbour setup that the last sample's surface read [ms]; null without a surface.</summary>
        public double? NeighbourSetup { get; private set; }

        /// <summary>Runs the steps before the saved state; <see cref="Last"/> then is their time.</summary>
        public IEnumerator Settle(BenchLiquid liquid)
        {
            int steps = 1;
            while (true)
            {
                cmd.Clear();
                cmd.BeginSample(frameMarker);
                bool more = liquid.Settle(cmd, steps);
                cmd.EndSample(frameMarker);
                if (!more) yield break;
                yield return Submit(() => liquid.Solver.ReadCountersNow(), 1);
                steps = (int)Math.Max(1.0, Math.Min(MostFramesAtOnce, SampleMilliseconds * steps / Math.Max(1e-3, Last.Total)));
            }
        }

        /// <summary>
        /// Measures frames from the saved state until they took <see cref="SampleMilliseconds"/>; <see cref="Last"/> is then their time.
        /// </summary>
        /// <param name="liquid">The liquid.</param>
        /// <param name="config">What a frame does.</param>
        /// <param name="expected">Expected time of a frame [ms]; 0 when it is not known.</param>
        public IEnumerator Sample(BenchLiquid liquid, BenchConfig config, double expected)
        {
            IBenchSurface surface = SurfaceOf(config, liquid.Solver);
            NeighbourSetup = null;
            BenchTimes? sum = null;
            do
            {
                liquid.Restore();
                // What only the first frame behind a restored state does is no part of the others': methods with a counting sort take the
                // particles in, and the sort of a surface serves the next step.
                if (!CaseMethod.IsThesis(liquid.Solver.Settings))
                {
                    yield return Prepare(liquid.Solver, () => liquid.Solver.RecordSteps(cmd, 1));
                }
                if (surface != null) yield return PrepareSurface(liquid.Solver, surface);
                double missing = Math.Min(SubmissionMilliseconds, SampleMilliseconds - (sum?.Total ?? 0.0));
                int steps = Math.Max(1, config.Steps);
                double frameTime = expected * steps;
                int frames = frameTime > 0.0
                    ? (int)Math.Max(1.0, Math.Min(MostFramesAtOnce / steps, Math.Ceiling(1.05 * missing / frameTime))) : 1;
                cmd.Clear();
                for (int i = 0; i < frames; i++) Record(liquid, config, surface);
                yield return Submit(() => liquid.Solver.ReadCountersNow(), frames);
                expected = Last.Frame / steps;
                sum = sum?.Plus(Last) ?? Last;
            }
            while (sum.Value.Total < SampleMilliseconds);
            Last = sum.Value.PerStep(config.Steps);
        }

        /// <summary>Measures copies of a buffer; <see cref="Last"/> is then their time, each a frame.</summary>
        public IEnumerator Copy(CopyBuffers buffers)
        {
            cmd.Clear();
            for (int i = 0; i < CopyBuffers.CopiesPerSample; i++)
            {
                cmd.BeginSample(frameMarker);
                buffers.Record(cmd);
                cmd.EndSample(frameMarker);
            }
            return Submit(buffers.Wait, CopyBuffers.CopiesPerSample);
        }

        public void Dispose()
        {
            foreach (IBenchSurface surface in surfaces.Values) surface.Dispose();
            clock.Dispose();
            cmd.Dispose();
            drawing.Dispose();
        }

        /// <summary>What a configuration's surface consisted of when it was drawn last; all nothing without one.</summary>
        public BenchSurfaceFacts FactsOf(in BenchConfig config) => surfaces.TryGetValue(config, out IBenchSurface surface)
            ? surface.Facts : default;

        private IEnumerator PrepareSurface(FluidSolver solver, IBenchSurface surface)
        {
            yield return Prepare(solver, () => solver.RecordNeighbourSetup(cmd));
            NeighbourSetup = Last.Total;
            for (int trial = 0; !surface.HasCapacity; trial++)
            {
                if (trial == MostTrials)
                {
                    throw new FluidDeviceException($"A surface reached no capacity for its mesh in {MostTrials} frames.");
                }
                yield return Prepare(solver, () => surface.RecordTrial(cmd, solver));
                surface.TakeTrial();
            }
        }

        private IEnumerator Prepare(FluidSolver solver, Action record)
        {
            cmd.Clear();
            cmd.BeginSample(frameMarker);
            record();
            cmd.EndSample(frameMarker);
            return Submit(() => solver.ReadCountersNow(), 1);
        }

        private void Record(BenchLiquid liquid, in BenchConfig config, IBenchSurface surface)
        {
            long before = GpuLaboratory.DispatchesRecorded;
            cmd.BeginSample(frameMarker);
            if (config.HasStep) liquid.Solver.RecordSteps(cmd, config.Steps);
            if (config.Kind == BenchSurfaceKind.Particles) drawing.RecordParticles(cmd, liquid.Solver);
            surface?.Record(cmd, liquid.Solver, drawing);
            cmd.EndSample(frameMarker);
            Dispatches = GpuLaboratory.DispatchesRecorded - before;
        }

        // Waits for the GPU by reading from it: a loop of empty frames would take a CPU that draws one of its cores.
        private IEnumerator Submit(Action read, int frames)
        {
            clock.Restart();
            Graphics.ExecuteCommandBuffer(cmd);
            read();
            for (int waited = 0; !clock.Collect(frames); waited++)
            {
                if (waited == EngineFramesToWait)
                {
                    throw new FluidDeviceException(
                        $"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) gave no GPU times within " +
                        $"{EngineFramesToWait} frames. Run the benchmark with Direct3D 11 or 12, outside a frame debugger.");
                }
                yield return null;
            }
            Last = clock.Times(frames);
        }

        private IBenchSurface SurfaceOf(in BenchConfig config, FluidSolver solver)
        {
            if (!config.HasSurface) return null;
            if (!surfaces.TryGetValue(config, out IBenchSurface surface))
            {
                surface = Create(config, solver);
                surfaces.Add(config, surface);
            }
            return surface;
        }

        private IBenchSurface Create(in BenchConfig config, FluidSolver solver)
        {
            switch (config.Kind)
            {
                case BenchSurfaceKind.Geometry: return new GeometryBenchSurface(shaders, config.Grid);
                case BenchSurfaceKind.DenseCompute: return new DenseBenchSurface(shaders, config.Grid);
                case BenchSurfaceKind.Water: return new WaterBenchSurface(shaders, config, solver.Settings);
                case BenchSurfaceKind.Whitewater: return new WhitewaterBenchSurface(shaders, config, solver);
                default: return new SparseBenchSurface(shaders, config, solver.Settings);
            }
        }
    }
}
