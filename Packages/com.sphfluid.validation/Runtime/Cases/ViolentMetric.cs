using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>Growth of kinetic and potential energy over the floor, and how high and how calm the liquid is at the end.</summary>
    public sealed class ViolentMetric : CaseMetric
    {
        internal const string ErrorName = "largest E/E0 − 1";
        internal const string HeightName = "height at the end over its volume's";
        internal const string DensityName = "largest density/ρ0";

        private readonly FluidSolverSettings settings;
        private readonly double depth;
        private readonly List<double> times = new List<double>();
        private readonly List<double> energies = new List<double>();
        private double height, densest, speed;

        /// <summary>A metric for one run.</summary>
        /// <param name="settings">The run's constants; gravity acts along −y.</param>
        /// <param name="depth">Height at which the liquid's volume stands at rest [m].</param>
        public ViolentMetric(in FluidSolverSettings settings, double depth)
        {
            this.settings = settings;
            this.depth = depth;
        }

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
            double sum = 0.0, centre = 0.0, squares = 0.0, floor = -0.5 * settings.DomainSize.y;
            for (int i = 0; i < state.Count; i++)
            {
                double square = Square(state.Velocities[i]), above = state.LocalPositions[i].y - floor;
                sum += 0.5 * square + settings.Gravity.magnitude * above;
                squares += square;
                centre += above;
                densest = Math.Max(densest, state.Densities[i] / (double)settings.RestDensity);
            }
            times.Add(time);
            energies.Add(sum / state.Count);
            height = 2.0 * centre / state.Count / depth;
            speed = Math.Sqrt(squares / state.Count);
        }

        /// <summary>Growth of the energy, zero where it only falls; height, density and root mean square of the speeds.</summary>
        public override IReadOnlyList<CaseError> Evaluate()
        {
            double start = energies.Count > 0 ? energies[0] : double.NaN, largest = start;
            foreach (double energy in energies) largest = Math.Max(largest, energy);
            return new[]
            {
                new CaseError(ErrorName, largest / start - 1.0),
                new CaseError(HeightName, energies.Count > 0 ? height : double.NaN),
                new CaseError(DensityName, energies.Count > 0 ? densest : double.NaN),
                new CaseError("v_rms at the end [m/s]", energies.Count > 0 ? speed : double.NaN),
            };
        }

        /// <inheritdoc/>
        public override IReadOnlyList<CaseSeries> Series()
        {
            var series = new CaseSeries("E/E0");
            for (int i = 0; i < times.Count; i++) series.Add(times[i], energies[i] / energies[0]);
            return new[] { series };
        }

        private static double Square(UnityEngine.Vector3 v) => (double)v.x * v.x + (double)v.y * v.y + (double)v.z * v.z;
    }
}
