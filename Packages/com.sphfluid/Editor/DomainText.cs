using System.Collections.Generic;
using UnityEngine;
using static System.FormattableString;

namespace SphFluid.Editor
{
    /// <summary>
    /// What a domain holds and costs, before a start by rule and measurement, in play as it is; as the inspector shows it.
    /// </summary>
    public readonly struct DomainText
    {
        private const double Mebibyte = 1024.0 * 1024.0;
        private const int Frames = 60; // a second
        private const double FrameTime = 1.0 / Frames;

        private DomainText(List<(string, string)> lines) => Lines = lines;

        /// <summary>Labels and values.</summary>
        public IReadOnlyList<(string Label, string Value)> Lines { get; }

        /// <summary>Of a simulation that would start so.</summary>
        /// <param name="simulation">The simulation, with a profile.</param>
        /// <param name="preview">What it would start with.</param>
        /// <returns>The text.</returns>
        internal static DomainText Before(FluidSimulation simulation, FluidPreview preview)
        {
            double needed = FrameTime / TimeStepText.StepOf(simulation, preview.Constants), most = simulation.MaxSubstepsPerFrame;
            double steps = System.Math.Min(needed, most);
            return new DomainText(new List<(string, string)>
            {
                ("Particles", Invariant($"{preview.Particles:N0}") + (preview.Particles == 0 ? ", until liquid is poured" : "")),
                Cells(preview.Constants),
                ("GPU memory", preview.Lack ?? Invariant($"{preview.GpuBytes / Mebibyte:0.0} MiB, without what draws it")),
                ("Steps a frame", needed <= most ? Invariant($"{steps:0.#} at {Frames} frames a second")
                    : Invariant($"{most:0}, the most allowed; {needed:0.#} keep real time at {Frames} frames a second")),
                ("GPU time a frame", Estimate(StepCostKey.Create(preview.Constants, preview.HasBodies), preview.Particles, steps)),
                ("Error class", Class(preview, 1.0)),
                ("Half the spacing", Finer(preview, needed)),
            });
        }

        // Particles fill a volume, and steps are as long as the spacing.
        private static string Finer(FluidPreview preview, double steps)
        {
            if (preview.Particles == 0) return "depends on what is poured";
            long particles = 8L * preview.Particles;
            string cost = StepCosts.TryFind(StepCostKey.Create(preview.Constants, preview.HasBodies), particles, out StepCost found)
                ? Invariant($", about {2.0 * found.Milliseconds * steps:0.0} ms") : "";
            return Invariant($"{particles:N0} particles, {2.0 * steps:0.#} steps a frame{cost}; class {Class(preview, 2.0)}");
        }

        private static string Class(FluidPreview preview, double finer)
        {
            if (preview.Particles == 0) return "depends on what is poured";
            FluidSolverSettings constants = preview.Constants;
            return preview.Depth > 0f
                ? ErrorClass.Describe(constants.Method, constants.SupportRadius / constants.Spacing,
                    finer * preview.Depth / constants.Spacing)
                : "none: without gravity there are no waves to measure it by";
        }

        /// <summary>Time that a number of steps takes, by what was measured on this device.</summary>
        /// <param name="key">Of which steps.</param>
        /// <param name="particles">Number of particles.</param>
        /// <param name="steps">Number of steps.</param>
        /// <returns>The text.</returns>
        internal static string Estimate(in StepCostKey key, long particles, double steps)
        {
            if (particles == 0) return "depends on what is poured";
            return StepCosts.TryFind(key, particles, out StepCost cost)
                ? Invariant($"about {cost.Milliseconds * steps:0.00} ms for the steps, by the last run with {cost.Particles:N0} ") +
                    Invariant($"particles on {SystemInfo.graphicsDeviceName}")
                : StepTimer.IsSupported ? "not measured on this device yet: look at it here in play" : "this device reports no GPU times";
        }

        /// <summary>Of a running simulation.</summary>
        /// <param name="simulation">The simulation.</param>
        /// <returns>The text.</returns>
        public static DomainText Now(FluidSimulation simulation) => new DomainText(new List<(string, string)>
        {
            ("Particles", Particles(simulation.ParticleCount, simulation.RemovedParticles)),
            Cells(simulation.Solver.Settings),
            ("GPU memory", Invariant($"{simulation.GpuBytes / Mebibyte:0.0} MiB, without what draws it")),
            ("Steps a frame", simulation.Timer == null || simulation.Timer.FrameCount == 0
                ? Invariant($"{FrameTime / simulation.TimeStep:0.#} at {Frames} frames a second")
                : Invariant($"{simulation.Timer.StepsAFrame:0.#}")),
            ("GPU time a frame", Measured(simulation.Timer)),
        });

        /// <summary>Measured time of the steps.</summary>
        /// <param name="timer">What measures it; null: nothing.</param>
        /// <returns>The text.</returns>
        internal static string Measured(StepTimer timer) =>
            !StepTimer.IsSupported ? "this device reports no GPU times"
            : timer == null || timer.FrameCount == 0 ? "no frame is measured yet"
            : Invariant($"{timer.MillisecondsAFrame:0.00} ms for the steps, mean of {timer.FrameCount} frames that had some");

        /// <summary>A number of particles, of which some may have left.</summary>
        /// <param name="count">Those that are there.</param>
        /// <param name="removed">Those that left.</param>
        /// <returns>The text.</returns>
        public static string Particles(long count, long removed) =>
            removed == 0 ? Invariant($"{count:N0}") : Invariant($"{count:N0}; {removed:N0} have left");

        /// <summary>Cells that a domain needs.</summary>
        internal static (string, string) Cells(in FluidSolverSettings settings) =>
            ("Cells", Invariant($"{CellChecks.Needed(settings):N0} of {CellChecks.Most(settings.Method):N0} at most"));
    }
}
