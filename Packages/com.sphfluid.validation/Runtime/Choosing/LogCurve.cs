using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// A positive quantity against a positive abscissa, straight between measured points on logarithmic axes, with the uncertainty of a
    /// Brownian bridge: nothing is known of the curve between two points but how much curves of its kind wander. At a distance s of the way
    /// l between two points the variance is W s (l − s)/l, beside that of the measurement itself; W comes from points that their neighbours
    /// predict.
    /// </summary>
    internal sealed class LogCurve
    {
        // Samples' logarithms below this are of no error at all.
        private const double Least = 1e-9;

        private readonly List<(double X, double Y, double Variance, int Count)> points;

        private LogCurve(List<(double, double, double, int)> points) => this.points = points;

        /// <summary>Whether there is a point.</summary>
        public bool IsEmpty => points.Count == 0;

        /// <summary>The least abscissa.</summary>
        public double First => Math.Exp(points[0].X);

        /// <summary>The greatest abscissa.</summary>
        public double Last => Math.Exp(points[points.Count - 1].X);

        /// <summary>Number of points.</summary>
        public int Count => points.Count;

        /// <summary>A curve through the medians of samples.</summary>
        /// <param name="samples">Abscissa and samples of each point, in any order.</param>
        public static LogCurve Of(IEnumerable<(double X, IReadOnlyList<double> Samples)> samples) =>
            new LogCurve(samples.OrderBy(s => s.X).Select(s =>
        {
            List<double> logarithms = s.Samples.Select(v => Math.Log(Math.Max(Least, v))).OrderBy(v => v).ToList();
            double mean = logarithms.Average();
            double squares = logarithms.Sum(v => (v - mean) * (v - mean));
            return (Math.Log(s.X), StepTimes.Quantile(logarithms, 0.5), squares, logarithms.Count);
        }).ToList());

        /// <summary>The same curve without falls: each point at least as high as every later one.</summary>
        public LogCurve Envelope()
        {
            var raised = new List<(double X, double Y, double Variance, int Count)>(points);
            for (int i = raised.Count - 2; i >= 0; i--)
            {
                raised[i] = (raised[i].X, Math.Max(raised[i].Y, raised[i + 1].Y), raised[i].Variance, raised[i].Count);
            }
            return new LogCurve(raised);
        }

        /// <summary>Σ of squared deviations of samples from their point's mean, and its degrees of freedom.</summary>
        public (double Squares, int Freedom) Scatter() => (points.Sum(p => p.Variance), points.Sum(p => p.Count - 1));

        /// <summary>Σ of the W that each inner point gives when its neighbours predict it, and their number.</summary>
        /// <param name="noise">Variance of a sample's logarithm.</param>
        public (double Sum, int Count) Wander(double noise)
        {
            double sum = 0.0;
            for (int i = 1; i < points.Count - 1; i++)
            {
                (double X, double Y, double, int Count) a = points[i - 1], p = points[i], b = points[i + 1];
                double share = (p.X - a.X) / (b.X - a.X), off = p.Y - (a.Y + share * (b.Y - a.Y));
                double own = noise * (1.0 / p.Count + (1.0 - share) * (1.0 - share) / a.Count + share * share / b.Count);
                sum += Math.Max(0.0, off * off - own) / ((p.X - a.X) * (b.X - p.X) / (b.X - a.X));
            }
            return (sum, Math.Max(0, points.Count - 2));
        }

        /// <summary>
        /// The slope of a straight line through all points, and its standard error; not numbers where there are too few points.
        /// </summary>
        public (double Slope, double Error) Slope()
        {
            if (points.Count < 2) return (double.NaN, double.NaN);
            double x = points.Average(p => p.X), y = points.Average(p => p.Y);
            double squares = points.Sum(p => (p.X - x) * (p.X - x)), slope = points.Sum(p => (p.X - x) * (p.Y - y)) / squares;
            double residuals = points.Sum(p => Math.Pow(p.Y - y - slope * (p.X - x), 2.0));
            return (slope, points.Count > 2 ? Math.Sqrt(residuals / (points.Count - 2) / squares) : double.NaN);
        }

        /// <summary>Logarithm of the curve; beyond its ends that of the end.</summary>
        public double At(double x)
        {
            (int i, double share) = Find(x);
            return i + 1 < points.Count ? points[i].Y + share * (points[i + 1].Y - points[i].Y) : points[i].Y;
        }

        /// <summary>Variance of the logarithm of one more measurement at an abscissa.</summary>
        /// <param name="x">The abscissa.</param>
        /// <param name="spread">How much measurements scatter and curves wander.</param>
        public double VarianceAt(double x, in CurveSpread spread)
        {
            (int i, double share) = Find(x);
            double noise = spread.NoiseOf(points[i].Variance, points[i].Count);
            double variance = noise * (1.0 + 1.0 / points[i].Count);
            if (i + 1 < points.Count && share > 0.0)
            {
                double next = spread.NoiseOf(points[i + 1].Variance, points[i + 1].Count);
                double way = points[i + 1].X - points[i].X;
                variance = (1.0 - share) * noise + share * next + (1.0 - share) * (1.0 - share) * noise / points[i].Count +
                    share * share * next / points[i + 1].Count +
                    spread.Wander * share * (1.0 - share) * way;
            }
            double away = Math.Max(Math.Max(0.0, points[0].X - Math.Log(x)), Math.Log(x) - points[points.Count - 1].X);
            return variance + spread.Wander * Math.Max(0.0, away);
        }

        // The point before, and the share of the way to the next.
        private (int Index, double Share) Find(double x)
        {
            double u = Math.Log(x);
            int i = points.FindLastIndex(p => p.X <= u + 1e-9);
            if (i < 0) return (0, 0.0);
            return i + 1 < points.Count ? (i, Math.Max(0.0, (u - points[i].X) / (points[i + 1].X - points[i].X))) : (i, 0.0);
        }
    }
}
