using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>
    /// Growth of kinetic, potential and elastic energy over what the start has above the state at rest. What is left at the end is below
    /// zero where the liquid at rest takes less space than it should.
    /// </summary>
    public sealed class EnergyMetric : CaseMetric
    {
        internal const string ErrorName = "largest E/E0 − 1";

        private readonly FluidSolverSettings settings;
        private readonly double rest;
        private readonly List<double> times = new List<double>();
        private readonly List<double> energies = new List<double>();

        /// <summary>A metric for one run.</summary>
        /// <param name="settings">The run's constants.</param>
        /// <param name="rest">Energy that is left when all is at rest [J], as <see cref="LiquidEnergy"/> counts it.</param>
        public EnergyMetric(in FluidSolverSettings settings, double rest)
        {
            this.settings = settings;
            this.rest = rest;
        }

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
            times.Add(time);
            energies.Add(LiquidEnergy.Of(state, settings).Total - rest);
        }

        /// <summary>Largest growth, zero where it only falls; and E/E0 at the end.</summary>
        public override IReadOnlyList<CaseError> Evaluate()
        {
            double start = energies.Count > 0 ? energies[0] : double.NaN, largest = start;
            foreach (double energy in energies) largest = Math.Max(largest, energy);
            return new[]
            {
                new CaseError(ErrorName, start > 0.0 ? largest / start - 1.0 : double.NaN),
                new CaseError("E/E0 at the end", start > 0.0 ? energies[energies.Count - 1] / start : double.NaN),
            };
        }

        /// <inheritdoc/>
        public override IReadOnlyList<CaseSeries> Series()
        {
            var series = new CaseSeries("E/E0");
            for (int i = 0; i < times.Count; i++) series.Add(times[i], energies[i] / energies[0]);
            return new[] { series };
        }
    }
}
