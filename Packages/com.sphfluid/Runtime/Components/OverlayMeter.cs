using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>
    /// Follows simulations from frame to frame and writes the overlay's text now and then. Between two texts it allocates nothing.
    /// </summary>
    internal sealed class OverlayMeter : IDisposable
    {
        private struct Followed
        {
            public FluidSimulation Simulation;
            public FluidSolver Solver;
            public long Steps, Setups, CapHits;
        }

        private readonly List<Followed> followed = new List<Followed>();
        private readonly List<LiquidFigures> figures = new List<LiquidFigures>();
        private readonly OverlayText writer = new OverlayText();
        private readonly StageClock clock;
        private StageTimes times;
        private double elapsed = double.PositiveInfinity;
        private long dispatches = ComputeKernel.DispatchesRecorded;
        private int frames;

        /// <param name="clock">Clock of the stages to begin with.</param>
        public OverlayMeter(StageClock clock) => this.clock = clock;

        /// <summary>The last text.</summary>
        public string Text { get; private set; } = "";

        /// <summary>Takes note of a frame.</summary>
        /// <param name="only">The simulation to follow; null: all that are enabled.</param>
        /// <param name="deltaTime">Time of the frame [s].</param>
        /// <param name="interval">Time between two texts [s]; the first comes at once.</param>
        /// <param name="withTimes">Whether times of the stages are measured.</param>
        /// <returns>Whether there is a new text.</returns>
        public bool Update(FluidSimulation only, double deltaTime, double interval, bool withTimes)
        {
            if (withTimes) times ??= new StageTimes(FluidStage.All, clock);
            else DropTimes();
            frames++;
            bool first = double.IsPositiveInfinity(elapsed);
            elapsed = first ? deltaTime : elapsed + deltaTime;
            if (!first && elapsed < interval) return false;
            Write(only);
            return true;
        }

        /// <inheritdoc/>
        public void Dispose() => DropTimes();

        private void Write(FluidSimulation only)
        {
            figures.Clear();
            bool worked = false;
            if (only != null) worked = Add(only);
            else
                for (int i = 0; i < FluidSimulation.Active.Count; i++) worked |= Add(FluidSimulation.Active[i]);
            for (int i = followed.Count - 1; i >= 0; i--)
                if (followed[i].Simulation == null) followed.RemoveAt(i);
            times?.Read(worked);
            long recorded = ComputeKernel.DispatchesRecorded - dispatches;
            Text = writer.Write(figures, times, FluidStage.All, elapsed / frames, recorded / (double)frames);
            dispatches += recorded;
            elapsed = 0.0;
            frames = 0;
        }

        private bool Add(FluidSimulation simulation)
        {
            int at = IndexOf(simulation);
            Followed before = followed[at];
            FluidSolver solver = simulation.Solver;
            if (before.Solver != solver) before = new Followed { Simulation = simulation, Solver = solver };
            Followed now = Now(simulation);
            figures.Add(Figures(simulation, solver, before, now));
            followed[at] = now;
            return now.Steps > before.Steps;
        }

        private int IndexOf(FluidSimulation simulation)
        {
            for (int i = 0; i < followed.Count; i++)
                if (followed[i].Simulation == simulation) return i;
            followed.Add(Now(simulation));
            return followed.Count - 1;
        }

        private static Followed Now(FluidSimulation simulation) => new Followed
        {
            Simulation = simulation, Solver = simulation.Solver, Steps = simulation.StepCount,
            Setups = simulation.Solver?.SetupCount ?? 0, CapHits = simulation.CapHits,
        };

        private LiquidFigures Figures(FluidSimulation simulation, FluidSolver solver, in Followed before, in Followed now)
        {
            var result = new LiquidFigures
            {
                Name = simulation.name, Runs = solver != null, State = State(simulation),
                Message = simulation.StatusMessage
            };
            if (solver == null) return result;
            FluidCounters counters = solver.Counters;
            if (simulation.MethodChoice is FluidMethodChoice choice) result.Method = MethodChoiceText.Short(choice);
            result.Particles = solver.LiveCount;
            result.Slots = solver.Capacity;
            result.Removed = counters.Removed;
            result.Refused = counters.Refused;
            result.StepsPerFrame = (now.Steps - before.Steps) / (double)frames;
            result.SetupsPerFrame = (now.Setups - before.Setups) / (double)frames;
            result.CapHits = now.CapHits - before.CapHits;
            result.MostSteps = simulation.MaxSubstepsPerFrame;
            result.TimeStep = simulation.TimeStep;
            result.RealTimeFactor = simulation.RealTimeFactor;
            result.Limit =
                FluidRules.Advise(solver.Settings, counters.MaxSpeed < float.PositiveInfinity ? counters.MaxSpeed : float.MaxValue).Limit;
            result.Bytes = simulation.GpuBytes;
            if (simulation.TryGetComponent(out IFluidDetailSource worth) && worth.IsOn) result.Detail = worth.Describe();
            return result;
        }

        private static string State(FluidSimulation simulation) =>
            !simulation.IsRunning ? "stopped" : simulation.Paused ? "paused" : simulation.IsAsleep ? "asleep" :
            simulation.AsleepShare > 0f ? FormattableString.Invariant($"running, {100f * simulation.AsleepShare:0} % asleep") : "running";

        private void DropTimes()
        {
            times?.Dispose();
            times = null;
        }
    }
}
