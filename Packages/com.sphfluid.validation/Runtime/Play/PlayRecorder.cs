using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Watches the simulations while a scene is played, and writes the liquid's part of the results at the end.</summary>
    [AddComponentMenu("")]
    [DefaultExecutionOrder(200)]
    internal sealed class PlayRecorder : MonoBehaviour
    {
        /// <summary>Columns of --record behind the frame's number.</summary>
        internal static readonly string[] RecordColumns =
        {
            "time_s", "simulation", "steps", "max_speed_m_s", "rms_speed_m_s", "density_error_mean", "density_error_max",
            "kinetic_energy_j",
            "centre_x_m", "centre_y_m", "centre_z_m", "close_share", "nearest_over_dx",
        };

        private readonly FrameTable frames = new FrameTable("steps", "setups", "dispatches", "particles");
        private readonly FrameTable record = new FrameTable(RecordColumns);
        private readonly InstrumentRecord instruments = new InstrumentRecord();
        private readonly Dictionary<FluidSimulation, SurfaceCaps> surfaces = new Dictionary<FluidSimulation, SurfaceCaps>();
        private readonly Dictionary<FluidSimulation, ColliderSides> sides = new Dictionary<FluidSimulation, ColliderSides>();
        private readonly PlaySequences sequences = new PlaySequences();
        private PlayArguments arguments;
        private long stepsBefore, setupsBefore, dispatchesBefore;
        private bool watched, seen;

        public static void Begin(PlayArguments arguments)
        {
            var holder = new GameObject("Play Recorder") { hideFlags = HideFlags.HideAndDontSave };
            DontDestroyOnLoad(holder);
            holder.AddComponent<PlayRecorder>().arguments = arguments;
        }

        private void OnEnable() => Application.quitting += Finish;

        private void OnDisable() => Application.quitting -= Finish;

        private void LateUpdate()
        {
            long steps = 0, setups = 0, particles = 0, dispatches = ComputeKernel.DispatchesRecorded;
            IReadOnlyList<FluidSimulation> simulations = FluidSimulation.Active;
            watched = true;
            seen |= simulations.Count > 0;
            for (int i = 0; i < simulations.Count; i++)
            {
                steps += simulations[i].StepCount;
                setups += simulations[i].Solver?.SetupCount ?? 0;
                particles += simulations[i].ParticleCount;
                if (!surfaces.TryGetValue(simulations[i], out SurfaceCaps caps)) surfaces.Add(simulations[i], caps = new SurfaceCaps());
                caps.Observe(PlaySurface.StatusOf(simulations[i]));
                if (simulations[i].IsRunning &&
                    !(sides.TryGetValue(simulations[i], out ColliderSides known) && known.AreOf(simulations[i])))
                {
                    sides[simulations[i]] = ColliderSides.Of(simulations[i], FluidSnapshot.Read(simulations[i]));
                }
                if (arguments.RecordFile != null && simulations[i].IsRunning) Record(i, simulations[i]);
                if (arguments.SequenceFolder != null && simulations[i].IsRunning)
                {
                    sequences.Write(i, simulations[i], arguments.SequenceFolder);
                }
            }
            frames.Add(steps - stepsBefore, setups - setupsBefore, dispatches - dispatchesBefore, particles);
            (stepsBefore, setupsBefore, dispatchesBefore) = (steps, setups, dispatches);
            if (simulations.Count > 0 && simulations.All(IsRefused))
            {
                CommandLine.Fail("play", "no liquid is left to play: all of the scene's were refused or have stopped, see above.",
                    CommandLine.FailureExitCode);
            }
        }

        private static bool IsRefused(FluidSimulation simulation) => !simulation.IsRunning &&
            simulation.Messages.Any(m => m.Severity == FluidSeverity.Error);

        private void Record(int index, FluidSimulation simulation)
        {
            FluidSnapshot snapshot = FluidSnapshot.Read(simulation);
            SnapshotStatistics s = SnapshotStatistics.Of(snapshot, simulation.Solver.Settings);
            ParticleGaps gaps = ParticleGaps.Of(snapshot.LocalPositions, simulation.Solver.Settings.Spacing);
            record.Add(simulation.SimulatedTime, index, simulation.StepCount, s.MaxSpeed, s.RmsSpeed,
                s.DensityErrorMean, s.DensityErrorMax, s.KineticEnergy, s.Centre.X, s.Centre.Y, s.Centre.Z,
                gaps.CloseShare, gaps.Nearest);
            instruments.AddRow(simulation);
        }

        private void Finish()
        {
            Application.quitting -= Finish;
            if (watched && !seen)
            {
                Debug.LogError(
                    $"{FluidMessage.Prefix} No liquid was played: no Fluid Simulation was enabled in the scene. Add one: GameObject > " +
                    "Fluid > Tank.");
            }
            try
            {
                sequences.Finish();
                var running = new List<FluidSimulation>();
                foreach (FluidSimulation simulation in FluidSimulation.Active)
                {
                    if (simulation.IsRunning) running.Add(simulation);
                }
                new PlayResults(arguments, running, surfaces, sides).Write(frames, record, instruments);
            }
            catch (Exception exception) when (exception is IOException || exception is UnauthorizedAccessException ||
                exception is InvalidDataException)
            {
                Debug.LogError($"{FluidMessage.Prefix} The results of the liquid could not be written: {exception.Message}");
            }
        }
    }
}
