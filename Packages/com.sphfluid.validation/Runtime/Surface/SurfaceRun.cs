using System;
using System.Collections;
using SphFluid.Laboratory;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>Makes a variant's surface of every frame of a state and measures it.</summary>
    internal sealed class SurfaceRun : IDisposable
    {
        // GPU times come some frames of the engine after the work; a device that gives none is not waited for longer.
        private const int EngineFramesToWait = 20;

        // In particle-steps of the Standard method: what a frame costs whatever its size, and for each particle.
        private const double FrameOverhead = 20000.0, ParticleWeight = 10.0;

        // States of fewer frames are gone through several times; the least time counts, as the first one also compiles.
        private const int TimedFrames = 3;

        private static readonly ProfilerMarker frameMarker = GpuLaboratory.CreateMarker(FrameBlocks.Frame);

        private static readonly BenchBlock surface = new BenchBlock("surface",
            "ResetMCGrid", "SetMCGridDensityFactors", "CountSurfaceVertices", "EmitSurfaceVertices",
            "ClearSurfaceBlocks", "PrepareSurfaceParticles", "ListSurfaceBlocks", "SampleBlocks", "CountBlocks",
            "SurfaceDrawArguments", "EmitBlocks");

        private readonly SurfaceState state;
        private readonly SurfaceVariant variant;
        private readonly FluidSolver solver;
        private readonly GpuClock clock = new GpuClock(new[] { surface });
        private readonly CommandBuffer cmd = new CommandBuffer { name = "Surface Run" };
        private double milliseconds;

        /// <summary>A run.</summary>
        /// <param name="state">A state with its frames.</param>
        /// <param name="variant">The variant; the caller's.</param>
        /// <param name="shaders">The package's shaders.</param>
        public SurfaceRun(SurfaceState state, SurfaceVariant variant, FluidShaderSet shaders)
        {
            this.state = state;
            this.variant = variant;
            solver = new FluidSolver(state.Settings, shaders, CaseLattice.Particles(state.Frames[0]));
        }

        /// <summary>
        /// Expected work: making and measuring each frame's surface, which a session's first ones of a variant show better.
        /// </summary>
        public static double CostOf(SurfaceState state, SurfaceVariant variant) =>
            Math.Max(state.FrameCount, variant.OnGpu ? TimedFrames : 1) * (FrameOverhead + ParticleWeight * state.ParticleCount);

        /// <summary>Whether the GPU's time is asked for.</summary>
        public bool IsTimed { get; set; } = true;

        /// <summary>The result, when the run has ended.</summary>
        public SurfaceQuality Result { get; private set; }

        /// <summary>The run; it yields after each frame.</summary>
        public IEnumerator Run()
        {
            var meter = new SurfaceMeter(state, variant.Cell);
            yield return Round(meter.Add);
            Result = meter.Result();
            Result.LateBlocks = variant.TakeLateBlocks();
            Result.GpuMilliseconds = milliseconds;
            for (int frames = state.Frames.Count; AsksTime && frames < TimedFrames; frames += state.Frames.Count)
            {
                yield return Round(_ => { });
                Result.GpuMilliseconds = Math.Min(milliseconds, Result.GpuMilliseconds);
            }
        }

        private bool AsksTime => IsTimed && variant.OnGpu;

        // All frames once; leaves their mean GPU time.
        private IEnumerator Round(Action<SurfaceMesh> take)
        {
            clock.Restart();
            int frames = 0;
            foreach (Vector3[] positions in state.Frames)
            {
                solver.SetParticles(CaseLattice.Particles(positions));
                cmd.Clear();
                cmd.BeginSample(frameMarker);
                solver.RecordNeighbourSetup(cmd);
                cmd.EndSample(frameMarker);
                Graphics.ExecuteCommandBuffer(cmd);
                take(variant.Mesh(state, solver, positions));
                clock.Collect(++frames);
                yield return null;
            }
            for (int waited = 0; AsksTime && waited < EngineFramesToWait && !clock.Collect(frames); waited++) yield return null;
            milliseconds = AsksTime && clock.Collect(frames) ? clock.Times(frames).Block(0) : double.NaN;
        }

        /// <summary>Runs to the end at once; for tests.</summary>
        public SurfaceQuality RunToEnd()
        {
            new SessionWork(Run()).Finish();
            return Result;
        }

        /// <inheritdoc/>
        public void Dispose()
        {
            solver.Dispose();
            clock.Dispose();
            cmd.Dispose();
        }
    }
}
