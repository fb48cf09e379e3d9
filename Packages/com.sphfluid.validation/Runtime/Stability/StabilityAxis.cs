using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>An axis of a map.</summary>
    public sealed class StabilityAxis
    {
        /// <summary>An axis.</summary>
        /// <param name="title">What it is, for instance "dt·c/R".</param>
        /// <param name="low">Its first value.</param>
        /// <param name="high">Its last value.</param>
        /// <param name="isLogarithmic">Whether its values have equal ratios instead of equal differences.</param>
        public StabilityAxis(string title, double low, double high, bool isLogarithmic = true)
        {
            Title = title;
            Low = low;
            High = high;
            IsLogarithmic = isLogarithmic;
        }

        /// <summary>What it is.</summary>
        public string Title { get; }

        /// <summary>First value.</summary>
        public double Low { get; }

        /// <summary>Last value.</summary>
        public double High { get; }

        /// <summary>Whether its values have equal ratios.</summary>
        public bool IsLogarithmic { get; }

        /// <summary>Values from the first to the last, rounded to the six digits that files have.</summary>
        /// <param name="count">Number of values, two or more.</param>
        public IReadOnlyList<double> Values(int count)
        {
            if (count < 2)
                throw new ArgumentOutOfRangeException(nameof(count), count, "An axis needs two values or more.");
            var values = new double[count];
            for (int i = 0; i < count; i++)
            {
                double t = i / (count - 1.0);
                double value = IsLogarithmic ? Low * Math.Pow(High / Low, t) : Low + (High - Low) * t;
                values[i] = double.Parse(CsvText.Text(Math.Abs(value) < 1e-9 ? 0.0 : value), System.Globalization.CultureInfo.InvariantCulture);
            }
            return values;
        }

        /// <summary>Place on the axis, 0 at the first value and 1 at the last.</summary>
        public double Place(double value) => IsLogarithmic ? Math.Log(value / Low) / Math.Log(High / Low) : (value - Low) / (High - Low);
    }
}
