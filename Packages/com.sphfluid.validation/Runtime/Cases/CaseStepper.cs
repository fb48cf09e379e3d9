using System;
using System.Collections.Generic;
using System.Diagnostics;
using SphFluid.Laboratory;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>
    /// Does a run's steps in submissions of bounded length and takes their GPU and CPU times. What the metric's samples cost is not in
    /// them; the neighbour setup that a sample needs is, as the next step finds it done: n steps have n of them.
    /// </summary>
    internal sealed class CaseStepper : IDisposable
    {
        // One submission: bounded so that no driver takes it for a hang, and a run can be stopped. By expected work and not by the clock:
        // lists of neighbours serve until a submission ends, so equal runs that were cut at other steps would differ in their last digits,
        // and then in more. In particle-steps at κ = 2, of which llvmpipe on two cores does a million a second.
        private const double SoftwareWork = 0.25e6, CardWork = 8e6, StepOverhead = 1000.0;
        private const int MostStepsAtOnce = 512;

        private static readonly ProfilerMarker marker = GpuLaboratory.CreateMarker(FrameBlocks.Frame);

        private readonly FluidSolver solver;
        private readonly CaseBodies bodies;
        private readonly GpuClock clock;
        private readonly CommandBuffer cmd = new CommandBuffer { name = "Validation Case" };
        private readonly Stopwatch recording = new Stopwatch();
        private readonly List<int> counts = new List<int>(); // steps of each submission
        private bool begun;
        private long steps;

        /// <param name="solver">The solver, with fresh neighbours.</param>
        /// <param name="timed">Whether GPU times are taken.</param>
        /// <param name="bodies">Bodies that move; null for none.</param>
        public CaseStepper(FluidSolver solver, bool timed, CaseBodies bodies = null)
        {
            this.solver = solver;
            this.bodies = bodies;
            clock = timed ? new GpuClock(Array.Empty<BenchBlock>()) : null;
        }

        /// <summary>GPU times of a step; not numbers when there are none.</summary>
        public StepTimes GpuTimes => clock == null || steps == 0 ? StepTimes.None
            : clock.FrameMilliseconds.Count == counts.Count ? StepTimes.Of(clock.FrameMilliseconds, counts)
            : StepTimes.Whole(clock.Times(1).Total, steps);

        /// <summary>Steps since the start, or since <see cref="Restart"/>.</summary>
        public long Steps => steps;

        /// <summary>CPU time of recording and submitting a step [ms].</summary>
        public double CpuMilliseconds => steps == 0 ? double.NaN : recording.Elapsed.TotalMilliseconds / steps;

        /// <summary>Does some steps and waits for the GPU.</summary>
        /// <param name="requested">Most steps to do.</param>
        /// <returns>What the solver counted up to now.</returns>
        public FluidCounters Step(long requested)
        {
            // The first step also builds pipelines, and is submitted alone.
            int count =
                (int)Math.Min(requested, begun ? MostAtOnce(solver.Settings, solver.ParticleCount, FluidSupport.IsSoftwareDevice) : 1);
            begun = true;
            recording.Start();
            bodies?.MoveTo(solver.SimulatedTime + count * (double)solver.Settings.TimeStep);
            cmd.Clear();
            cmd.BeginSample(marker);
            solver.RecordSteps(cmd, count);
            solver.RecordNeighbourSetup(cmd);
            cmd.EndSample(marker);
            Graphics.ExecuteCommandBuffer(cmd);
            recording.Stop();
            FluidCounters counters = solver.ReadCountersNow();
            counts.Add(count);
            steps += count;
            return counters;
        }

        /// <summary>Most steps of a submission: the same whenever and however fast a run is done.</summary>
        /// <param name="settings">The liquid's constants.</param>
        /// <param name="particles">Number of particles.</param>
        /// <param name="software">Whether the device is a CPU.</param>
        internal static int MostAtOnce(in FluidSolverSettings settings, int particles, bool software)
        {
            double ratio = settings.SupportRadius / settings.Spacing / 2.0;
            double step = StepOverhead + Math.Max(1.0, ratio * ratio * ratio) * particles;
            return (int)Math.Max(1.0, Math.Min(MostStepsAtOnce, (software ? SoftwareWork : CardWork) / step));
        }

        /// <summary>Whether all GPU times are in; called once a frame of the engine until they are.</summary>
        public bool Collect() => clock == null || clock.Collect(counts.Count);

        /// <summary>Forgets the times so far: those of a first step are no example of the others.</summary>
        public void Restart()
        {
            clock?.Restart();
            recording.Reset();
            counts.Clear();
            steps = 0;
        }

        public void Dispose()
        {
            clock?.Dispose();
            cmd.Dispose();
        }
    }
}
