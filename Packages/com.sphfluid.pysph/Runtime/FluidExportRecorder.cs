using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid
{
    /// <summary>
    /// Exports liquids in play mode: records where colliders are, frame by frame, and hands the exports over when their time is over.
    /// </summary>
    public sealed class FluidExportRecorder : IDisposable
    {
        private readonly IReadOnlyList<FluidSimulation> simulations;
        private readonly FluidExportOptions options;
        private readonly Action<IReadOnlyList<FluidExport>> done;
        private readonly List<FluidExport> exports = new List<FluidExport>();
        private readonly FluidExportFrames frames;
        private double begun;

        private FluidExportRecorder(IReadOnlyList<FluidSimulation> simulations, FluidExportOptions options,
            Action<IReadOnlyList<FluidExport>> done)
        {
            this.simulations = simulations;
            this.options = options;
            this.done = done;
            frames = FluidExportFrames.Begin(this);
        }

        /// <summary>Part of the time that is recorded, 0 to 1.</summary>
        public float Progress { get; private set; }

        /// <summary>Whether it goes on: until the exports were handed over, or it is disposed of.</summary>
        public bool IsRecording { get; private set; } = true;

        /// <summary>Begins in the next LateUpdate, when objects that came with this frame have started; in play mode.</summary>
        /// <param name="simulations">Liquids, running or not.</param>
        /// <param name="options">What is computed.</param>
        /// <param name="done">Receives the exports, in the order of the simulations, once; they are disposed of after it.</param>
        /// <returns>The recorder; dispose of it to end it before.</returns>
        /// <exception cref="ArgumentNullException">Something is missing.</exception>
        /// <exception cref="ArgumentException">An option is out of range.</exception>
        public static FluidExportRecorder Begin(IReadOnlyList<FluidSimulation> simulations, FluidExportOptions options,
            Action<IReadOnlyList<FluidExport>> done)
        {
            if (simulations == null) throw new ArgumentNullException(nameof(simulations));
            if (options == null) throw new ArgumentNullException(nameof(options));
            if (done == null) throw new ArgumentNullException(nameof(done));
            options.Validate();
            return new FluidExportRecorder(simulations, options, done);
        }

        /// <summary>Ends it; exports that were not handed over are dropped.</summary>
        public void Dispose()
        {
            IsRecording = false;
            foreach (FluidExport export in exports) export.Dispose();
            exports.Clear();
            if (frames != null) Object.Destroy(frames.gameObject);
        }

        /// <summary>Once a frame, after the liquids' own LateUpdate.</summary>
        internal void Advance()
        {
            if (!IsRecording) return;
            if (exports.Count == 0) Take();
            double now = Time.timeAsDouble - begun;
            bool complete = true;
            Progress = 1f;
            foreach (FluidExport export in exports)
            {
                if (!export.HasLiquid) continue;
                export.Note(now);
                complete &= export.IsComplete;
                Progress = Mathf.Min(Progress, export.Progress);
            }
            if (!complete) return;
            IsRecording = false;
            try
            {
                done(exports);
            }
            finally
            {
                Dispose();
            }
        }

        private void Take()
        {
            begun = Time.timeAsDouble;
            foreach (FluidSimulation simulation in simulations) exports.Add(FluidExport.Begin(simulation, options));
        }
    }
}
