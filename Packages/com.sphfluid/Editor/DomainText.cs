using System.Collections.Generic;
using static System.FormattableString;

namespace SphFluid.Editor
{
    /// <summary>What a domain holds and costs, as the inspector shows it.</summary>
    public readonly struct DomainText
    {
        const double Mebibyte = 1024.0 * 1024.0;

        DomainText(List<(string, string)> lines) => Lines = lines;

        /// <summary>Labels and values.</summary>
        public IReadOnlyList<(string Label, string Value)> Lines { get; }

        /// <summary>Of a simulation that would start with these constants.</summary>
        /// <param name="constants">Its constants.</param>
        /// <returns>The text.</returns>
        public static DomainText Before(in FluidSolverSettings constants) =>
            new DomainText(new List<(string, string)> { Cells(constants) });

        /// <summary>Of a running simulation.</summary>
        /// <param name="simulation">The simulation.</param>
        /// <returns>The text.</returns>
        public static DomainText Now(FluidSimulation simulation) => new DomainText(new List<(string, string)>
        {
            ("Particles", Particles(simulation.ParticleCount, simulation.RemovedParticles)),
            Cells(simulation.Solver.Settings),
            ("GPU memory", Invariant($"{simulation.GpuBytes / Mebibyte:0.0} MiB")),
        });

        /// <summary>A number of particles, of which some may have left.</summary>
        /// <param name="count">Those that are there.</param>
        /// <param name="removed">Those that left.</param>
        /// <returns>The text.</returns>
        public static string Particles(long count, long removed) =>
            removed == 0 ? Invariant($"{count:N0}") : Invariant($"{count:N0}; {removed:N0} have left");

        static (string, string) Cells(in FluidSolverSettings settings) =>
            ("Cells", Invariant($"{CellChecks.Needed(settings):N0} of {CellChecks.Most(settings.Method):N0} at most"));
    }
}
