using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Reads the water's height at the four gauges and holds it against <see cref="MarinHeights"/>. The gauges' x counts from
    /// the domain's low face of x, the floor is the low face of y, the centreline z = 0.
    /// <para>A gauge sees the particles nearer than two spacings along x and z, weighted by a tent, so that how the lattice lies
    /// to the gauge does not matter. Its height is their volume over the tent's area, as a wire that reports its wetted length
    /// sees it; particles above a stretch of two spacings with less than half a layer are spray and do not count.</para>
    /// </summary>
    public sealed class MarinMetric : CaseMetric
    {
        /// <summary>Reach of a gauge to each side over dx.</summary>
        public const double Reach = 2.0;

        internal const string ErrorName = "heights, normalised RMS";

        // Of the (2 · 2)² particles of a layer.
        private const int HalfLayer = 8;

        // The wave is back at the gauge in the water's own place 3.8 s after the start; before 2.5 s the water there only sinks.
        private const int ReturnGauge = 3;
        private const double ReturnsAfter = 2.5;

        private readonly FluidSolverSettings settings;
        private readonly SampledCurve[] heights = new SampledCurve[MarinHeights.Gauges.Length];
        private readonly List<double>[] pressures = { new List<double>(), new List<double>() }; // on the box's front and top
        private readonly List<double> levels = new List<double>();
        private readonly List<(double Level, double Weight)> column = new List<(double Level, double Weight)>();

        /// <summary>A metric for one run.</summary>
        /// <param name="settings">The run's constants; gravity along −y.</param>
        public MarinMetric(in FluidSolverSettings settings)
        {
            this.settings = settings;
            for (int gauge = 0; gauge < heights.Length; gauge++) heights[gauge] = new SampledCurve();
        }

        /// <inheritdoc/>
        public override void Read(double time, CaseReadings readings)
        {
            for (int face = 0; time > 0.0 && face < readings.Pressures.Count; face++) pressures[face].Add(readings.Pressures[face]);
        }

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
            for (int gauge = 0; gauge < heights.Length; gauge++) heights[gauge].Add(time, Height(state, MarinHeights.Gauges[gauge]));
        }

        /// <summary>
        /// The mean over the gauges of RMS(h − h_exp)/RMS(h_exp) from 0 to 6 s, then each gauge's, then how much of the wave that
        /// comes back from the far wall is missing: its highest water at the last gauge after 2.5 s over the record's, less 1.
        /// <para>With this unit a gauge that stays dry errs by 1. Water that stands at its final level of 0.211 m all the time
        /// errs by 0.40: most of the record is level. The last of them sees what the others average away.</para>
        /// <para>Where the force on walls is measured also RMS(p − p_exp)/RMS(p_exp) of means over 50 ms on the box's front and on its top,
        /// and the impulse on each from 0 to 6 s over the record's, less 1.</para>
        /// </summary>
        public override IReadOnlyList<CaseError> Evaluate()
        {
            var errors = new List<CaseError>();
            double sum = 0.0;
            for (int gauge = 0; gauge < heights.Length; gauge++)
            {
                double error = NormalisedRms(gauge);
                sum += error;
                errors.Add(new CaseError($"height at {Place(gauge)}, normalised RMS", error));
            }
            errors.Insert(0, new CaseError(ErrorName, sum / heights.Length));
            errors.Add(new CaseError("returning wave, height − 1", ReturningWave(heights[ReturnGauge].At) / ReturningWave(Record) - 1.0));
            AddPressure(errors, "front", pressures[0], MarinPressures.Front);
            AddPressure(errors, "top", pressures[1], MarinPressures.Top);
            return errors;
        }

        /// <inheritdoc/>
        public override IReadOnlyList<CaseSeries> Series()
        {
            var result = new List<CaseSeries>();
            for (int gauge = 0; gauge < heights.Length; gauge++)
            {
                string place = Place(gauge);
                var record = new CaseSeries($"{place}, MARIN", true);
                for (int row = 0; row < MarinHeights.Rows; row++) record.Add(row * MarinHeights.Interval, MarinHeights.Heights[gauge][row]);
                result.Add(record);
                result.Add(heights[gauge].ToSeries(place, 1.0, 0.0));
            }
            return result;
        }

        private static void AddPressure(List<CaseError> errors, string face, List<double> measured, double[] record)
        {
            if (measured.Count < record.Length) return;
            double squares = 0.0, unit = 0.0, sum = 0.0, own = 0.0;
            for (int i = 0; i < record.Length; i++)
            {
                squares += (measured[i] - record[i]) * (measured[i] - record[i]);
                unit += record[i] * record[i];
                sum += measured[i];
                own += record[i];
            }
            errors.Add(new CaseError($"pressure on the {face} of the box, normalised RMS", Math.Sqrt(squares / unit)));
            errors.Add(new CaseError($"impulse on the {face} of the box over the record's − 1", sum / own - 1.0));
        }

        private static string Place(int gauge) => FormattableString.Invariant($"x = {MarinHeights.Gauges[gauge]:0.000} m");

        private double Height(FluidSnapshot state, double gauge)
        {
            Vector3 low = -0.5f * settings.DomainSize;
            double dx = settings.Spacing;
            levels.Clear();
            column.Clear();
            foreach (Vector3 position in state.LocalPositions)
            {
                double x = Math.Abs(position.x - low.x - gauge) / (Reach * dx), z = Math.Abs(position.z) / (Reach * dx);
                if (!(x < 1.0 && z < 1.0)) continue;
                levels.Add((double)position.y - low.y);
                column.Add((levels[levels.Count - 1], (1.0 - x) * (1.0 - z)));
            }
            int liquid = LiquidReach.Of(levels, HalfLayer, dx).Count;
            double weights = 0.0;
            foreach ((double level, double weight) in column) weights += liquid > 0 && level <= levels[liquid - 1] ? weight : 0.0;
            return weights * dx / (Reach * Reach);
        }

        private static double Record(double time) => MarinHeights.Heights[ReturnGauge][(int)Math.Round(time / MarinHeights.Interval)];

        private static double ReturningWave(Func<double, double> height)
        {
            double highest = 0.0;
            for (int row = (int)(ReturnsAfter / MarinHeights.Interval); row < MarinHeights.Rows; row++)
            {
                highest = Math.Max(highest, height(row * MarinHeights.Interval));
            }
            return highest;
        }

        // At the record's own times; not a number where the run ended earlier.
        private double NormalisedRms(int gauge)
        {
            double squares = 0.0, unit = 0.0;
            for (int row = 0; row < MarinHeights.Rows; row++)
            {
                double record = MarinHeights.Heights[gauge][row];
                double error = heights[gauge].At(row * MarinHeights.Interval) - record;
                squares += error * error;
                unit += record * record;
            }
            return Math.Sqrt(squares / unit);
        }
    }
}
