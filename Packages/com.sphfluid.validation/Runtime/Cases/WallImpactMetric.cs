using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// The pressure that four gauges in a wall feel, force per area averaged between samples, held against
    /// <see cref="ConvergedPressure"/> by the run's own time, which begins when the water is let go.
    /// </summary>
    public sealed class WallImpactMetric : CaseMetric
    {
        internal const string ErrorName = "pressure at four gauges, RMS over their own";

        // In √(H/g): what is compared are means over Width, Part apart, from the first whose water may have come to the last.
        private const double Width = 0.3, Part = 0.05, First = 2.35, Last = 5.85;

        // By when the lowest gauge has felt so much of ρ g H √(H/g), the water has come: what it feels in a fortieth of √(H/g).
        private const double Arrival = 0.05;

        private static readonly MeanCurve[] converged = ConvergedPressure.Pressures.Select(Curve).ToArray();

        private readonly double time, pressure;
        private readonly MeanCurve[] gauges = ConvergedPressure.Gauges.Select(_ => new MeanCurve(0.0)).ToArray();

        /// <summary>A metric for one run.</summary>
        /// <param name="time">√(H/g) [s].</param>
        /// <param name="pressure">ρ g H [Pa].</param>
        public WallImpactMetric(double time, double pressure)
        {
            this.time = time;
            this.pressure = pressure;
        }

        /// <summary>What this metric finds between two solvers that have converged.</summary>
        internal static double BetweenSolvers { get; } = Errors(ConvergedPressure.SecondSolver.Select(Curve).ToArray()).Average();

        /// <inheritdoc/>
        public override void Read(double time, CaseReadings readings)
        {
            for (int i = 0; time > 0.0 && i < readings.Pressures.Count; i++)
            {
                gauges[i].Add(time / this.time, readings.Pressures[i] / pressure);
            }
        }

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
        }

        /// <summary>
        /// The mean over the gauges of RMS(p − p_converged)/RMS(p_converged) of means over 0.3 √(H/g); each gauge's; what all gauges feel
        /// over what they should, less 1; how late the water comes; the highest mean at the lowest gauge over the converged one, less 1.
        /// </summary>
        public override IReadOnlyList<CaseError> Evaluate()
        {
            double[] errors = Errors(gauges);
            var result = new List<CaseError> { new CaseError(ErrorName, errors.Average()) };
            for (int i = 0; i < errors.Length; i++) result.Add(new CaseError($"pressure at {Place(i)}, RMS over its own", errors[i]));
            result.Add(new CaseError("impulse on the gauges over the converged one − 1", gauges.Sum(Felt) / converged.Sum(Felt) - 1.0));
            result.Add(new CaseError("water comes late, over √(H/g)", gauges[0].TimeOf(Arrival) - converged[0].TimeOf(Arrival)));
            result.Add(new CaseError($"highest mean at {Place(0)} over the converged one − 1",
                Highest(gauges[0]) / Highest(converged[0]) - 1.0));
            return result;
        }

        /// <inheritdoc/>
        public override IReadOnlyList<CaseSeries> Series()
        {
            var series = new List<CaseSeries>();
            for (int i = 0; i < gauges.Length; i++)
            {
                string name = $"{Place(i)}, converged";
                series.Add(converged[i].ToSeries(name, ConvergedPressure.Start, true));
                if (MeasuredPressure.Experiments[i].Length > 0) series.Add(Experiments(name, MeasuredPressure.Experiments[i]));
                series.Add(gauges[i].ToSeries(Place(i), ConvergedPressure.Start));
            }
            return series;
        }

        private static CaseSeries Experiments(string name, double[][] experiments)
        {
            var band = new CaseSeries(name, true);
            for (int i = 0; i < experiments[0].Length; i++)
            {
                band.AddBand(ConvergedPressure.Start + (i + 0.5) * MeasuredPressure.Interval, experiments.Min(e => e[i]),
                    experiments.Max(e => e[i]));
            }
            return band;
        }

        private static string Place(int gauge) => FormattableString.Invariant($"y = {ConvergedPressure.Gauges[gauge]:0.00} H");

        private static MeanCurve Curve(double[] means) => new MeanCurve(ConvergedPressure.Start, ConvergedPressure.Interval, means);

        private static IEnumerable<double> Times() =>
            Enumerable.Range(0, (int)Math.Round((Last - First) / Part) + 1).Select(i => First + i * Part);

        // Not numbers where a run ends early.
        private static double[] Errors(MeanCurve[] curves) => curves.Select((curve, i) =>
            Math.Sqrt(Times().Sum(t => Square(curve.Mean(t, Width) - converged[i].Mean(t, Width))) /
                Times().Sum(t => Square(converged[i].Mean(t, Width))))).ToArray();

        private static double Felt(MeanCurve curve) => curve.Integral(Last + 0.5 * Width) - curve.Integral(First - 0.5 * Width);

        private static double Highest(MeanCurve curve) => Times().Max(t => curve.Mean(t, Width));

        private static double Square(double value) => value * value;
    }
}
