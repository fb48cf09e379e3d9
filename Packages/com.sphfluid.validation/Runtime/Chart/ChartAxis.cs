using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A logarithmic axis with labels that suit its length.</summary>
    public readonly struct ChartAxis
    {
        private const double LeastSpan = 4.0;
        private const double Margin = 1.35;
        private const double LongestWithThrees = 12.0;
        private const double LongestWithHalves = 300.0;

        private ChartAxis(double low, double high)
        {
            Low = low;
            High = high;
        }

        /// <summary>Its left or lower end.</summary>
        public double Low { get; }

        /// <summary>Its right or upper end.</summary>
        public double High { get; }

        /// <summary>An axis that shows some values with a margin.</summary>
        /// <param name="values">Values; those that are not finite and positive are not shown.</param>
        /// <param name="below">Free space below the least, over the length that the values need.</param>
        /// <param name="above">Free space above the greatest, likewise.</param>
        public static ChartAxis Of(IEnumerable<double> values, double below = 0.0, double above = 0.0)
        {
            List<double> shown = values.Where(v => v > 0.0 && !double.IsInfinity(v)).ToList();
            if (shown.Count == 0) shown.AddRange(new[] { 0.01, 1.0 });
            double low = shown.Min() / Margin, high = shown.Max() * Margin;
            double missing = Math.Sqrt(Math.Max(1.0, LeastSpan / (high / low)));
            low /= missing;
            high *= missing;
            return new ChartAxis(low / Math.Pow(high / low, below), high * Math.Pow(high / low, above));
        }

        /// <summary>
        /// The labelled values: 1, 2, 3, 5, 10, ... on a short axis, without the 3 on a longer one, powers of ten on a long one.
        /// </summary>
        public IReadOnlyList<double> Tics() =>
            Multiples(High / Low <= LongestWithThrees ? "1235" : High / Low <= LongestWithHalves ? "125" : "1");

        /// <summary>The value as a part of a hundred: 0.02 is "2 %", 10 is "1k %".</summary>
        public static string Percent(double value) => Short(100.0 * value) + " %";

        /// <summary>The value with a letter for thousands and millions: 20000 is "20k".</summary>
        public static string Short(double value)
        {
            string letter = value >= 999999.5 ? "M" : value >= 999.5 ? "k" : "";
            double unit = letter == "M" ? 1e6 : letter == "k" ? 1e3 : 1.0;
            return (value / unit).ToString("G3", CultureInfo.InvariantCulture) + letter;
        }

        internal string Script(string axis, Func<double, string> label)
        {
            // Labels of tics are formats: %% is a per cent sign.
            string tics = string.Join(", ", Tics().Select(t => Gnuplot.Quote(label(t).Replace("%", "%%")) + " " + Gnuplot.Number(t))
                .Concat(Multiples("23456789").Except(Tics()).Select(t => "'' " + Gnuplot.Number(t) + " 1")));
            return $"set {axis}range [{Gnuplot.Number(Low)}:{Gnuplot.Number(High)}]\nset {axis}tics ({tics})";
        }

        // The digits times powers of ten that lie on the axis.
        private IReadOnlyList<double> Multiples(string digits)
        {
            var values = new List<double>();
            for (int exponent = (int)Math.Floor(Math.Log10(Low)); exponent <= (int)Math.Ceiling(Math.Log10(High)); exponent++)
            {
                foreach (char digit in digits)
                {
                    double value = double.Parse(digit + "e" + exponent.ToString(CultureInfo.InvariantCulture), NumberStyles.Float,
                        CultureInfo.InvariantCulture);
                    if (value >= Low && value <= High) values.Add(value);
                }
            }
            return values;
        }
    }
}
