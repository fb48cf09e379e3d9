using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Reads a liquid without waiting for the GPU, so that what it reads is some frames old: <see cref="FluidProbe"/>,
    /// <see cref="FluidGauge"/> and <see cref="FluidFlux"/>. Readings begin anew when the liquid starts anew or what is read changes.
    /// </summary>
    public abstract class FluidInstrument : MonoBehaviour
    {
        private static readonly List<FluidInstrument> ActiveList = new List<FluidInstrument>();

        [SerializeField, Min(0f), Tooltip("The reading is the mean over this many simulated seconds. 0: not averaged.")]
        private float averagingTime = 0.1f;

        [SerializeField,
            Tooltip(
                "Simulation that is read. Empty: the simulation among this object's parents, else the only one in the scene, else the " +
                "one whose domain holds this object.")]
        private FluidSimulation simulation;

        private FluidSimulation read; // whose liquid is asked
        private FluidSolver solver;
        private int jumps;
        private FluidMessage? problem;
        private int firstFrame;

        private protected FluidInstrument()
        {
        }

        /// <summary>Raised on the main thread after each new reading.</summary>
        public event Action<FluidInstrument> Received;

        /// <summary>Enabled instruments of all loaded scenes.</summary>
        public static IReadOnlyList<FluidInstrument> Active => ActiveList;

        /// <summary>The reading is the mean over the last so many simulated seconds, 0 or more; 0: not averaged.</summary>
        public float AveragingTime { get => Limits.Clamp(averagingTime, 0f); set => averagingTime = value; }

        /// <summary>Simulation that is read; null: found as the tooltip says.</summary>
        public FluidSimulation Simulation { get => simulation; set => simulation = value; }

        /// <summary>The simulation that is read now; null: none.</summary>
        public FluidSimulation Liquid => read;

        /// <summary>Whether there is a reading: the liquid runs, and an answer has come.</summary>
        public bool HasValue => ReadTime >= 0.0;

        /// <summary>The main reading, in the unit of the first of <see cref="Readings"/>; 0 while there is none.</summary>
        public float Value => HasValue ? (float)MainValue : 0f;

        /// <summary>Simulated time that the reading is of [s]; −1 while there is none.</summary>
        public double ReadTime { get; private set; } = -1.0;

        /// <summary>Why it cannot read, or what is doubtful about what it reads; null: nothing.</summary>
        public FluidMessage? Problem => problem;

        /// <summary>All readings with names and units, the main one first; values are not numbers while there are none.</summary>
        public abstract IReadOnlyList<FluidReading> Readings { get; }

        /// <summary>The main reading; read only while there is one.</summary>
        private protected abstract double MainValue { get; }

        /// <summary>Waits for the GPU and takes the newest answers; for tools and tests.</summary>
        public void ReadNow()
        {
            if (!isActiveAndEnabled) return;
            Track();
            if (read == null || !read.IsRunning) return;
            read.Queries.Complete();
            if (read.Solver.MeasuresWallForces) read.Solver.WallForces.Complete();
            Track();
        }

        /// <summary>Forgets what was read; means, peaks and totals begin anew.</summary>
        public virtual void Clear() => ReadTime = -1.0;

        /// <summary>Asks the liquid from now on, or where this object is now; in each frame.</summary>
        /// <returns>What is wrong; null: nothing.</returns>
        private protected abstract FluidMessage? Ask(FluidSimulation liquid);

        /// <summary>Takes what has arrived.</summary>
        /// <returns>Simulated time of a new reading [s]; −1: there is none.</returns>
        private protected abstract double Measure(FluidSimulation liquid);

        /// <summary>Ends the questions to a liquid that may have stopped.</summary>
        private protected abstract void Leave(FluidSimulation liquid);

        /// <summary>A warning about this instrument.</summary>
        private protected FluidMessage Warn(string text, string cure) =>
            new FluidMessage(FluidSeverity.Warning, FluidIssue.InstrumentInvalid, this, text, cure);

        private void OnEnable()
        {
            firstFrame = Time.frameCount;
            ActiveList.Add(this);
        }

        private void OnDisable()
        {
            ActiveList.Remove(this);
            Begin(null);
        }

        private void Update() => Track();

        private void Track()
        {
            FluidSimulation owner = FluidScene.Owner(this, simulation, FluidSimulation.Active);
            if (owner != read) Begin(owner);
            if (read == null)
            {
                // Simulations of the scene may be enabled after this.
                if (Time.frameCount > firstFrame + 2)
                {
                    SetProblem(Warn(FluidSimulation.Active.Count == 0 ? "There is no Fluid Simulation to read."
                        : "It is in none of the scene's Fluid Simulations, so none is read.",
                        "Assign Simulation, or make this a child of one."));
                }
                return;
            }
            if (!read.IsRunning || read.Solver != solver || solver.ParticleChanges != jumps)
            {
                Leave(read);
                Clear();
                solver = read.IsRunning ? read.Solver : null;
                jumps = solver?.ParticleChanges ?? 0;
            }
            if (!read.IsRunning) return;
            bool isPlaced = AffineMath.IsFinite(transform.position) && AffineMath.IsFinite(transform.up);
            SetProblem(isPlaced ? Ask(read) : Warn("Its position is not finite, so nothing is read.", "Set it to numbers in metres."));
            double time = isPlaced ? Measure(read) : -1.0;
            if (time < 0.0 || time == ReadTime) return;
            ReadTime = time;
            Received?.Invoke(this);
        }

        private void Begin(FluidSimulation owner)
        {
            if (read is object) Leave(read);
            Clear();
            read = owner;
            solver = null;
            problem = null;
        }

        // Said once.
        private void SetProblem(FluidMessage? now)
        {
            if (now.Equals(problem)) return;
            problem = now;
            if (now is FluidMessage message) message.Log();
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void ResetStatics() => ActiveList.Clear();
    }
}
