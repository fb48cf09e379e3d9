using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>
    /// The pressure that a gauge in a wall feels, force per area averaged between samples, held against <see cref="BuchnerPressure"/>. The
    /// experiment's clock starts with a gate: one shift in time is fitted and told.
    /// </summary>
    public sealed class WallImpactMetric : CaseMetric
    {
        internal const string ErrorName = "pressure, shifted RMS over its own";
        internal const string RawName = "pressure, RMS over its own";

        /// <summary>Largest shift, in √(H/g).</summary>
        public const double LargestShift = 0.3;

        // In √(H/g): the record in equal parts, and where the pressure is even.
        private const double Part = 0.05, EvenFrom = 3.3, EvenTo = 5.0;

        private static readonly SampledCurve record = Record();

        private readonly double time, pressure;
        private readonly SampledCurve measured = new SampledCurve();
        private double last;

        /// <summary>A metric for one run.</summary>
        /// <param name="time">√(H/g) [s].</param>
        /// <param name="pressure">ρ g H [Pa].</param>
        public WallImpactMetric(double time, double pressure)
        {
            this.time = time;
            this.pressure = pressure;
        }

        /// <inheritdoc/>
        public override void Read(double time, CaseReadings readings)
        {
            // A mean between two samples is that of the time between them.
            if (time > 0.0 && readings.Pressures.Count > 0) measured.Add(0.5 * (last + time) / this.time, readings.Pressures[0] / pressure);
            last = time;
        }

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
        }

        /// <summary>
        /// RMS of the pressure's error over the record's after the shift of least error; without it; the shift, positive where the record
        /// is later; the mean while the pressure is even, and the highest, over the record's, less 1.
        /// </summary>
        public override IReadOnlyList<CaseError> Evaluate()
        {
            double shift = BestShift();
            return new[]
            {
                new CaseError(ErrorName, Rms(shift)),
                new CaseError(RawName, Rms(0.0)),
                new CaseError("shift in time over √(H/g)", -shift),
                new CaseError("even pressure over the record's − 1", Mean(measured, shift) / Mean(record, 0.0) - 1.0),
                new CaseError("highest pressure over the record's − 1", Highest(measured) / Highest(record) - 1.0),
            };
        }

        /// <inheritdoc/>
        public override IReadOnlyList<CaseSeries> Series()
        {
            var exact = new CaseSeries("Buchner's gauge", true);
            foreach ((double x, double y) in record.Points) exact.Add(x, y);
            return new[] { exact, measured.ToSeries("gauge", 1.0, 0.0) };
        }

        private static SampledCurve Record()
        {
            var curve = new SampledCurve();
            for (int i = 0; i < BuchnerPressure.Times.Length; i++) curve.Add(BuchnerPressure.Times[i], BuchnerPressure.Pressures[i]);
            return curve;
        }

        private double BestShift()
        {
            double best = double.NaN, least = double.PositiveInfinity;
            for (int i = -300; i <= 300; i++)
            {
                double rms = Rms(LargestShift * i / 300.0);
                if (rms < least) (least, best) = (rms, LargestShift * i / 300.0);
            }
            return best;
        }

        // Of p(t + shift) against the record at t; not a number where the run does not reach.
        private double Rms(double shift)
        {
            double squares = 0.0, own = 0.0;
            for (double t = BuchnerPressure.Times[0]; t <= record.LastX - LargestShift; t += Part)
            {
                double right = record.At(t), error = measured.At(t + shift) - right;
                squares += error * error;
                own += right * right;
            }
            return Math.Sqrt(squares / own);
        }

        private static double Mean(SampledCurve curve, double shift)
        {
            double sum = 0.0;
            int count = 0;
            for (double t = EvenFrom; t <= EvenTo; t += Part, count++) sum += curve.At(t + shift);
            return sum / count;
        }

        // From the first hit on, and before the water comes back.
        private static double Highest(SampledCurve curve)
        {
            double highest = double.NegativeInfinity;
            foreach ((double x, double y) in curve.Points) highest = x <= EvenTo ? Math.Max(highest, y) : highest;
            return highest;
        }
    }
}
