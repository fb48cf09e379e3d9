using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>
    /// A quantity over time that is known by its means over intervals that join, as a gauge reads the force of its steps. It gives the mean
    /// over any other interval: (1, 3) over [0, 1] and [1, 2] has the mean 2 over [0.5, 1.5].
    /// </summary>
    internal sealed class MeanCurve
    {
        private readonly SampledCurve integral = new SampledCurve();

        /// <param name="start">When the first interval begins.</param>
        public MeanCurve(double start) => integral.Add(start, 0.0);

        /// <summary>Means over intervals of one length.</summary>
        public MeanCurve(double start, double interval, double[] means) : this(start)
        {
            for (int i = 0; i < means.Length; i++) Add(start + (i + 1) * interval, means[i]);
        }

        /// <summary>Adds the mean of the time from the last interval's end on.</summary>
        public void Add(double end, double mean)
        {
            double last = integral.LastX;
            integral.Add(end, Integral(last) + mean * (end - last));
        }

        /// <summary>The integral since the start; not a number before it and after the last interval.</summary>
        public double Integral(double time) => integral.At(time);

        /// <summary>The mean about a time; not a number where that reaches beyond the intervals.</summary>
        public double Mean(double middle, double length) =>
            (Integral(middle + 0.5 * length) - Integral(middle - 0.5 * length)) / length;

        /// <summary>When the integral first comes to a value; not a number where it never does.</summary>
        public double TimeOf(double value)
        {
            IReadOnlyList<(double X, double Y)> points = integral.Points;
            for (int i = 1; i < points.Count; i++)
            {
                (double X, double Y) a = points[i - 1], b = points[i];
                if (b.Y >= value) return a.X + (value - a.Y) / (b.Y - a.Y) * (b.X - a.X);
            }
            return double.NaN;
        }

        /// <summary>The means as they were added, each in the middle of its interval, from a time on.</summary>
        public CaseSeries ToSeries(string name, double from, bool isReference = false)
        {
            var series = new CaseSeries(name, isReference);
            IReadOnlyList<(double X, double Y)> points = integral.Points;
            for (int i = 1; i < points.Count; i++)
            {
                (double X, double Y) a = points[i - 1], b = points[i];
                if (a.X >= from) series.Add(0.5 * (a.X + b.X), (b.Y - a.Y) / (b.X - a.X));
            }
            return series;
        }
    }
}
