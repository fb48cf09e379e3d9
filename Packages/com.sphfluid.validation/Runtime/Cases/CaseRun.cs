using System;
using System.Collections;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Runs a set-up on the GPU and shows its states to a metric. All waiting is by yielding a frame of the engine. It ends early where
    /// the metric, or what holds for every liquid, finds the run failed.
    /// </summary>
    public sealed class CaseRun : IDisposable
    {
        private const int EngineFramesToWait = 400;

        private readonly CaseSetup setup;
        private readonly CaseMetric metric;
        private readonly bool timed;
        private readonly CaseSchedule schedule;
        private readonly CaseFailure failures;
        private readonly CaseObstacles obstacles;
        private readonly CaseBodies bodies;
        private readonly CaseWalls walls;
        private readonly FluidSolver solver;
        private CaseStepper stepper;
        private bool disposed;

        /// <summary>A run that has not begun.</summary>
        /// <param name="setup">What to run.</param>
        /// <param name="metric">What watches it.</param>
        /// <param name="shaders">The compute shaders.</param>
        /// <param name="timed">Whether GPU times are taken; they need frames of the engine to go by.</param>
        /// <exception cref="ArgumentException">The set-up cannot be run; the message says why.</exception>
        /// <exception cref="FluidDeviceException">The device cannot run it.</exception>
        public CaseRun(CaseSetup setup, CaseMetric metric, FluidShaderSet shaders, bool timed = false)
        {
            this.setup = setup ?? throw new ArgumentNullException(nameof(setup));
            this.metric = metric ?? throw new ArgumentNullException(nameof(metric));
            this.timed = timed;
            schedule = new CaseSchedule(setup.Duration, setup.SampleInterval, setup.Settings.TimeStep);
            bodies = new CaseBodies(setup.Bodies);
            obstacles = new CaseObstacles(setup.Obstacles, true, bodies);
            failures = new CaseFailure(setup);
            try
            {
                solver = new FluidSolver(setup.Settings, shaders, setup.Particles);
                obstacles.GiveTo(solver);
                walls = new CaseWalls(solver, setup.Patches);
            }
            catch
            {
                solver?.Dispose();
                obstacles.Dispose();
                throw;
            }
        }

        /// <summary>The result, when the run has ended.</summary>
        public CaseResult Result { get; private set; }

        /// <summary>The run, a part at each step of the enumerator; it yields where a frame of the engine has to go by.</summary>
        public IEnumerator Run()
        {
            string failure = Sample();
            stepper?.Dispose();
            stepper = new CaseStepper(solver, timed, bodies);
            long due = schedule.Next(0);
            while (failure == null && solver.StepCount < schedule.LastStep)
            {
                failure = CaseFailure.Of(stepper.Step(due - solver.StepCount));
                yield return null;
                if (solver.StepCount == 1 && schedule.LastStep > 1)
                {
                    yield return WaitForTimes();
                    stepper.Restart();
                }
                stepper.Collect();
                if (failure != null || solver.StepCount < due) continue;
                failure = Sample();
                due = schedule.Next(due);
            }
            yield return WaitForTimes();
            Result = End(failure);
        }

        /// <summary>Runs to the end at once, without GPU times; for tests and tools.</summary>
        /// <exception cref="InvalidOperationException">The run is a timed one.</exception>
        public CaseResult RunToEnd()
        {
            if (timed)
            {
                throw new InvalidOperationException("GPU times need frames of the engine: go through Run, or make the run without times.");
            }
            new SessionWork(Run()).Finish();
            return Result;
        }

        /// <summary>Frees the GPU memory.</summary>
        public void Dispose()
        {
            if (disposed) return;
            disposed = true;
            stepper?.Dispose();
            solver.Dispose();
            obstacles.Dispose();
        }

        // Shows the state to the metric; why the run ends here, or null.
        private string Sample()
        {
            FluidSnapshot state = FluidSnapshot.Read(solver);
            var readings = new CaseReadings(bodies.Read(solver.SimulatedTime), walls.Read());
            string failure = failures.Of(state, readings);
            if (failure == null)
            {
                metric.Read(solver.SimulatedTime, readings);
                metric.Sample(solver.SimulatedTime, state);
                failure = metric.Failure;
            }
            return failure;
        }

        private IEnumerator WaitForTimes()
        {
            for (int waited = 0; !stepper.Collect(); waited++)
            {
                if (waited == EngineFramesToWait)
                {
                    throw new FluidDeviceException(
                        $"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) gave no GPU times within " +
                        $"{EngineFramesToWait} frames. Run it with Direct3D 11 or 12, outside a frame debugger.");
                }
                yield return null;
            }
        }

        private CaseResult End(string failure)
        {
            var result = new CaseResult
            {
                Failure = failure == null ? null : FormattableString.Invariant($"{failure}, at {solver.SimulatedTime:G3} s"),
                Particles = solver.ParticleCount,
                Steps = solver.StepCount,
                Counters = solver.ReadCountersNow(),
                SimulatedSeconds = solver.SimulatedTime,
                TimeStep = setup.Settings.TimeStep,
                GpuTimes = stepper.GpuTimes,
                GpuMsPerSecond = stepper.GpuTimes.Median / setup.Settings.TimeStep,
                CpuMsPerSecond = stepper.CpuMilliseconds / setup.Settings.TimeStep,
            };
            result.Take(metric);
            return result;
        }
    }
}
