using System;

namespace SphFluid.Validation
{
    /// <summary>Holds a curve against points whose clock may have started earlier or later than the curve's.</summary>
    internal static class TimeShiftFit
    {
        private const int Trials = 100;
        private const double Tolerance = 1e-6;
        private static readonly double goldenSection = 0.5 * (Math.Sqrt(5.0) - 1.0);

        /// <summary>Root mean square of curve(x_i + shift)/y_i − 1; not a number where the curve does not reach.</summary>
        public static double RelativeRms(SampledCurve curve, double[] xs, double[] ys, int first, double shift)
        {
            double sum = 0.0;
            for (int i = first; i < xs.Length; i++)
            {
                double error = curve.At(xs[i] + shift) / ys[i] - 1.0;
                sum += error * error;
            }
            return Math.Sqrt(sum / (xs.Length - first));
        }

        /// <summary>
        /// The shift of least <see cref="RelativeRms"/> within ±<paramref name="range"/>; not a number where none can be had.
        /// </summary>
        public static double Best(SampledCurve curve, double[] xs, double[] ys, int first, double range)
        {
            // The best of evenly spaced trials first: with noise there is more than one minimum.
            double step = 2.0 * range / Trials, best = double.NaN, least = double.PositiveInfinity;
            for (int i = 0; i <= Trials; i++)
            {
                double rms = RelativeRms(curve, xs, ys, first, -range + i * step);
                if (rms < least)
                {
                    least = rms;
                    best = -range + i * step;
                }
            }
            double low = Math.Max(-range, best - step), high = Math.Min(range, best + step);
            while (high - low > Tolerance)
            {
                double a = high - goldenSection * (high - low), b = low + goldenSection * (high - low);
                // A trial beyond the curve's end is not a number, which counts as worse.
                if (RelativeRms(curve, xs, ys, first, a) <= RelativeRms(curve, xs, ys, first, b))
                    high = b;
                else
                    low = a;
            }
            double refined = 0.5 * (low + high);
            return RelativeRms(curve, xs, ys, first, refined) <= least ? refined : best;
        }
    }
}
