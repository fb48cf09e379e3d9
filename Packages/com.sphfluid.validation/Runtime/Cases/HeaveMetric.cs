using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>
    /// Follows the height of a floating box that was released above its place at rest, and holds it against linear potential flow.
    /// </summary>
    public sealed class HeaveMetric : CaseMetric
    {
        internal const string ErrorName = "heave, RMS over its own";

        private readonly SampledCurve exact = new SampledCurve();
        private readonly SampledCurve measured = new SampledCurve();
        private readonly double rest, draught, start;

        /// <summary>A metric for one run.</summary>
        /// <param name="exact">Height above rest [m] at equal intervals from zero on.</param>
        /// <param name="interval">The interval [s].</param>
        /// <param name="rest">y of the box's origin where it floats at rest [m], simulation space.</param>
        /// <param name="draught">Depth of its bottom there [m].</param>
        public HeaveMetric(IReadOnlyList<double> exact, double interval, double rest, double draught)
        {
            for (int i = 0; i < exact.Count; i++) this.exact.Add(i * interval, exact[i]);
            this.rest = rest;
            this.draught = draught;
            start = exact[0];
        }

        /// <inheritdoc/>
        public override void Read(double time, CaseReadings readings)
        {
            double height = readings.Bodies[0].y - rest;
            measured.Add(time, height);
            if (!(Math.Abs(height) < draught))
            {
                Failure = FormattableString.Invariant($"the box is {height:0.###} m above its place at rest");
            }
        }

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
        }

        /// <summary>
        /// RMS of the height's error over the exact heave's, without its mean, which is the draught's error: less water displaced is more
        /// than none. Then that over the draught, less water positive; time and height of the first trough and crest over the exact ones,
        /// less 1.
        /// </summary>
        public override IReadOnlyList<CaseError> Evaluate()
        {
            double offset = 0.0, squares = 0.0, own = 0.0;
            int count = 0;
            foreach ((double time, double height) in measured.Points)
            {
                double right = exact.At(Math.Min(time, exact.LastX));
                offset += height - right;
                squares += (height - right) * (height - right);
                own += right * right;
                count++;
            }
            offset /= count;
            (double Time, double Height) trough = Turn(measured, 0.0, -1.0), exactTrough = Turn(exact, 0.0, -1.0);
            (double Time, double Height) crest = Turn(measured, trough.Time, 1.0), exactCrest = Turn(exact, exactTrough.Time, 1.0);
            return new[]
            {
                new CaseError(ErrorName, Math.Sqrt(Math.Max(0.0, squares - count * offset * offset) / own)),
                new CaseError("floats too high, over the draught", offset / draught),
                new CaseError("first trough, time over the exact one − 1", trough.Time / exactTrough.Time - 1.0),
                new CaseError("first trough, depth over the exact one − 1", (trough.Height - offset) / exactTrough.Height - 1.0),
                new CaseError("first crest, time over the exact one − 1", crest.Time / exactCrest.Time - 1.0),
                new CaseError("first crest, height over the exact one − 1", (crest.Height - offset) / exactCrest.Height - 1.0),
            };
        }

        /// <inheritdoc/>
        public override IReadOnlyList<CaseSeries> Series()
        {
            var series = new[] { new CaseSeries("linear potential flow", true), new CaseSeries("heave") };
            foreach ((double time, double height) in exact.Points) series[0].Add(time, height / start);
            foreach ((double time, double height) in measured.Points) series[1].Add(time, height / start);
            return series;
        }

        // The first lowest (sign −1) or highest point after a time: nothing within a fifth of a second to either side is beyond it.
        private static (double Time, double Height) Turn(SampledCurve curve, double after, double sign)
        {
            IReadOnlyList<(double X, double Y)> points = curve.Points;
            for (int i = 1; i + 1 < points.Count; i++)
            {
                if (points[i].X <= after || !IsTurn(points, i, sign)) continue;
                return Vertex(points[i - 1], points[i], points[i + 1]);
            }
            return (double.NaN, double.NaN);
        }

        private static bool IsTurn(IReadOnlyList<(double X, double Y)> points, int at, double sign)
        {
            const double Window = 0.2;
            if (points[at].X - points[0].X < Window || points[points.Count - 1].X - points[at].X < Window) return false;
            for (int i = 0; i < points.Count; i++)
            {
                if (Math.Abs(points[i].X - points[at].X) <= Window && sign * points[i].Y > sign * points[at].Y) return false;
            }
            return true;
        }

        // Of the parabola through three points.
        private static (double Time, double Height) Vertex((double X, double Y) a, (double X, double Y) b, (double X, double Y) c)
        {
            double left = (b.Y - a.Y) / (b.X - a.X), right = (c.Y - b.Y) / (c.X - b.X);
            double curvature = (right - left) / (c.X - a.X);
            if (curvature == 0.0) return b;
            double slope = left + curvature * (b.X - a.X);
            return (b.X - 0.5 * slope / curvature, b.Y - 0.25 * slope * slope / curvature);
        }
    }
}
