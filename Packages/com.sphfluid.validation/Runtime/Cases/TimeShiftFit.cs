using System;

namespace SphFluid.Validation
{
    /// <summary>Holds a curve against points whose clock may have started earlier or later than the curve's.</summary>
    internal static class TimeShiftFit
    {
        private const int Trials = 150;
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

        /// <summary>The shift of least <see cref="RelativeRms"/>; not a number where none can be had.</summary>
        /// <exception cref="SearchBoundException">It lies at a bound of the range or outside.</exception>
        public static double Best(SampledCurve curve, double[] xs, double[] ys, int first, SearchRange range) =>
            range.Require(Least(curve, xs, ys, first, range));

        /// <summary>Whether there is a shift of least <see cref="RelativeRms"/> within the range.</summary>
        public static bool TryBest(SampledCurve curve, double[] xs, double[] ys, int first, SearchRange range, out double shift)
        {
            shift = Least(curve, xs, ys, first, range);
            return range.Contains(shift);
        }

        // Half as far again as the range to both sides.
        private static double Least(SampledCurve curve, double[] xs, double[] ys, int first, SearchRange range)
        {
            double from = range.Low - 0.25 * (range.High - range.Low), to = range.High + 0.25 * (range.High - range.Low);
            // The best of evenly spaced trials first: with noise there is more than one minimum.
            double step = (to - from) / Trials, best = double.NaN, least = double.PositiveInfinity;
            for (int i = 0; i <= Trials; i++)
            {
                double rms = RelativeRms(curve, xs, ys, first, from + i * step);
                if (rms < least) (least, best) = (rms, from + i * step);
            }
            double low = Math.Max(from, best - step), high = Math.Min(to, best + step);
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
