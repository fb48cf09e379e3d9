using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Records colliders for exports while the scene plays, and hands the exports over when their time is over.</summary>
    [AddComponentMenu("")]
    [DefaultExecutionOrder(300)]
    public sealed class FluidExportRecorder : MonoBehaviour
    {
        readonly List<FluidExport> exports = new List<FluidExport>();
        IReadOnlyList<FluidSimulation> simulations;
        FluidExportOptions options;
        Action<IReadOnlyList<FluidExport>> done;
        double begun;

        /// <summary>Part of the time that is recorded, 0 to 1.</summary>
        public float Progress { get; private set; }

        /// <summary>Begins in the next LateUpdate, when objects that came with this frame have started; in play mode.</summary>
        /// <param name="simulations">Liquids, running or not.</param>
        /// <param name="options">What is computed.</param>
        /// <param name="done">Receives the exports, in the order of the simulations, once; they are disposed of after it.</param>
        /// <returns>The recorder, which removes itself at the end. Destroy its object to end it before.</returns>
        /// <exception cref="ArgumentNullException">Something is missing.</exception>
        /// <exception cref="ArgumentException">An option is out of range.</exception>
        public static FluidExportRecorder Begin(IReadOnlyList<FluidSimulation> simulations, FluidExportOptions options, Action<IReadOnlyList<FluidExport>> done)
        {
            if (simulations == null) throw new ArgumentNullException(nameof(simulations));
            if (options == null) throw new ArgumentNullException(nameof(options));
            if (done == null) throw new ArgumentNullException(nameof(done));
            options.Validate();
            var holder = new GameObject("Fluid Export") { hideFlags = HideFlags.HideAndDontSave };
            DontDestroyOnLoad(holder);
            var recorder = holder.AddComponent<FluidExportRecorder>();
            (recorder.simulations, recorder.options, recorder.done) = (simulations, options, done);
            return recorder;
        }

        void LateUpdate()
        {
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
            enabled = false;
            try
            {
                done(exports);
            }
            finally
            {
                Destroy(gameObject);
            }
        }

        void Take()
        {
            begun = Time.timeAsDouble;
            foreach (FluidSimulation simulation in simulations) exports.Add(FluidExport.Begin(simulation, options));
        }

        void OnDestroy()
        {
            foreach (FluidExport export in exports) export.Dispose();
            exports.Clear();
        }
    }
}
