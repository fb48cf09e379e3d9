using System;

namespace SphFluid.Validation
{
    /// <summary>A predicted value with an interval in which 19 of 20 measurements are expected.</summary>
    public readonly struct Estimate
    {
        /// <summary>Half width of the interval over the standard deviation.</summary>
        internal const double Deviations = 2.0;

        /// <summary>A prediction.</summary>
        /// <param name="value">The value.</param>
        /// <param name="low">Lower end of the interval.</param>
        /// <param name="high">Upper end of the interval.</param>
        public Estimate(double value, double low, double high)
        {
            Value = value;
            Low = low;
            High = high;
        }

        /// <summary>The value.</summary>
        public double Value { get; }

        /// <summary>Lower end of the interval.</summary>
        public double Low { get; }

        /// <summary>Upper end of the interval.</summary>
        public double High { get; }

        /// <summary>
        /// What five of six measurements keep below: a deviation above the value. Choices go by it, else the luckiest point would win.
        /// </summary>
        public double Likely => Math.Sqrt(Value * High);

        /// <summary>Whether a measured value lies within the interval.</summary>
        public bool Contains(double measured) => measured >= Low && measured <= High;

        /// <summary>The value and its interval times a factor.</summary>
        public Estimate Times(double factor) => new Estimate(Value * factor, Low * factor, High * factor);

        /// <summary>Of a logarithm and its standard deviation.</summary>
        internal static Estimate OfLogarithm(double logarithm, double deviation) =>
            new Estimate(Math.Exp(logarithm), Math.Exp(logarithm - Deviations * deviation), Math.Exp(logarithm + Deviations * deviation));
    }
}
