using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Watches the simulation on the same GameObject: measures its liquid every few frames without waiting for the GPU, and names what goes
    /// wrong with the setting that cures it. Runs in the Editor and in development builds; in release players where
    /// <see cref="RunInPlayers"/>
    /// says so.
    /// </summary>
    [AddComponentMenu("SPH Fluid/Fluid Diagnostics")]
    [RequireComponent(typeof(FluidSimulation))]
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(110)]
    [ManualPage("diagnostics")]
    public sealed class FluidDiagnostics : MonoBehaviour
    {
        // A GPU that lags further behind is not given more to measure.
        private const int MostUnderWay = 4;

        [SerializeField, Range(1, 1000), Tooltip("Frames from one measurement to the next. A measurement costs about as much as one step.")]
        private int interval = 10;

        [SerializeField, Tooltip("Run in release builds too. Off: in the Editor and in development builds only.")]
        private bool runInPlayers;

        private readonly FindingEpisodes episodes = new FindingEpisodes();
        private FluidSimulation simulation;
        private FluidStatisticsMeter meter;
        private FluidDetectors detectors;
        private FluidSolver refused;
        private CommandBuffer commands;
        private int countdown;
        private long colliderChanges;

        /// <summary>Raised on the main thread with each measurement, after <see cref="Findings"/> was brought up to date.</summary>
        public event Action<FluidStatistics> Measured;

        /// <summary>Raised when a failure is found that was not there before, after it was reported.</summary>
        public event Action<FluidFinding> Found;

        /// <summary>Frames from one measurement to the next, 1 to 1000.</summary>
        public int Interval { get => Mathf.Clamp(interval, 1, 1000); set => interval = value; }

        /// <summary>Whether release players measure too.</summary>
        public bool RunInPlayers { get => runInPlayers; set => runInPlayers = value; }

        /// <summary>Whether this build measures.</summary>
        public bool Runs => RunsIn(Application.isEditor, Debug.isDebugBuild, runInPlayers);

        /// <summary>The last measurement; all zero before the first.</summary>
        public FluidStatistics Statistics { get; private set; }

        /// <summary>Measurements of the present run of the simulation.</summary>
        public long MeasurementCount { get; private set; }

        /// <summary>What is wrong as of the last measurement; empty when all is well or nothing runs.</summary>
        public IReadOnlyList<FluidFinding> Findings { get; private set; } = Array.Empty<FluidFinding>();

        /// <summary>Energies are compared from the next measurement on: for scripts that give the liquid energy on purpose.</summary>
        public void Rebase() => detectors?.Rebase();

        internal static bool RunsIn(bool editor, bool developmentBuild, bool requested) => editor || developmentBuild || requested;

        private void LateUpdate()
        {
            if (simulation == null) TryGetComponent(out simulation);
            FluidSolver solver = simulation != null && Runs ? simulation.Solver : null;
            if (solver == null || solver == refused)
            {
                Forget();
                return;
            }
            if (meter == null || meter.Solver != solver) Begin(solver);
            if (simulation.IsAsleep && MeasurementCount > 0) return;
            if (meter == null || --countdown > 0 || meter.UnderWay >= MostUnderWay) return;
            countdown = Interval;
            Measure();
        }

        private void OnDisable() => Forget();

        private void OnDestroy() => commands?.Dispose();

        private void Begin(FluidSolver solver)
        {
            Forget();
            try
            {
                meter = new FluidStatisticsMeter(simulation.Profile.Shaders, solver);
            }
            catch (FluidDeviceException exception)
            {
                refused = solver;
                simulation.Report(new FluidMessage(FluidSeverity.Warning, FluidIssue.Diagnosis, simulation, exception.Message,
                    "The liquid runs without diagnostics."));
                return;
            }
            meter.MeasuredAt += Receive;
            detectors = new FluidDetectors(solver.Settings, simulation.Profile.KinematicViscosity);
            colliderChanges = simulation.Collision.Changes + solver.BirthCount;
            Publish(IsJudged ? detectors.Check() : Array.Empty<FluidFinding>());
        }

        private void Measure()
        {
            // A collider that moved since the last measurement has done work, as force zones do, and liquid that was born brings energy.
            long changes = simulation.Collision.Changes + meter.Solver.BirthCount;
            commands ??= new CommandBuffer { name = "Fluid Diagnostics" };
            commands.Clear();
            meter.Record(commands, changes != colliderChanges || meter.Solver.State.Zones?.Count > 0);
            Graphics.ExecuteCommandBuffer(commands);
            colliderChanges = changes;
        }

        private void Receive(FluidStatistics statistics, FluidMoment moment)
        {
            detectors.Apply(moment.Settings);
            if (moment.WorkDone) detectors.Rebase();
            Statistics = statistics;
            MeasurementCount++;
            Publish(IsJudged ? detectors.Update(statistics, meter.Solver.Counters) : Array.Empty<FluidFinding>());
            Measured?.Invoke(statistics);
        }

        private void Publish(IReadOnlyList<FluidFinding> findings)
        {
            Findings = findings;
            episodes.Begin();
            for (int i = 0; i < findings.Count; i++)
            {
                FluidFinding finding = findings[i];
                if (!episodes.IsNew(finding.Failure) || !IsReported(finding.Failure)) continue;
                simulation.Report(new FluidMessage(FluidSeverity.Warning, FluidIssue.Diagnosis, simulation, finding.Text, finding.Cure));
                Found?.Invoke(finding);
            }
        }

        // What goes wrong is a matter of steps, and a liquid that is played has none.
        private bool IsJudged => !simulation.IsPlayedBack;

        // True of every thin liquid that the method calms: worth showing, no warning.
        private static bool IsReported(FluidFailure failure) => failure != FluidFailure.NumericalViscosity;

        private void Forget()
        {
            if (meter == null) return;
            meter.Dispose();
            meter = null;
            detectors = null;
            countdown = 0;
            MeasurementCount = 0;
            Statistics = default;
            Findings = Array.Empty<FluidFinding>();
            episodes.Clear();
        }
    }
}
