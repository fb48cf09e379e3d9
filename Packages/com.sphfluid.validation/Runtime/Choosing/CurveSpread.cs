using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// How much measurements at a point scatter, and how much curves wander between points, as several curves show it together.
    /// </summary>
    internal readonly struct CurveSpread
    {
        // What is expected before anything is measured counts like so many measurements.
        private const double Trust = 2.0;

        private CurveSpread(double noise, double wander)
        {
            Noise = noise;
            Wander = wander;
        }

        /// <summary>Variance of a sample's logarithm.</summary>
        public double Noise { get; }

        /// <summary>Variance that the logarithm gains over a way by a factor e.</summary>
        public double Wander { get; }

        /// <summary>Nothing measured yet.</summary>
        /// <param name="noise">Expected deviation of a sample's logarithm: 0.05 is five per cent.</param>
        /// <param name="wander">Expected deviation of the logarithm over a way by a factor e.</param>
        public static CurveSpread Expected(double noise, double wander) => new CurveSpread(noise * noise, wander * wander);

        /// <summary>Of some curves; where they say little, near what was expected.</summary>
        public static CurveSpread Of(IReadOnlyList<LogCurve> curves, in CurveSpread expected)
        {
            List<(double Squares, int Freedom)> scatter = curves.Select(c => c.Scatter()).ToList();
            double noise = (scatter.Sum(s => s.Squares) + Trust * expected.Noise) / (scatter.Sum(s => s.Freedom) + Trust);
            List<(double Sum, int Count)> wander = curves.Select(c => c.Wander(noise)).ToList();
            return new CurveSpread(noise, (wander.Sum(w => w.Sum) + Trust * expected.Wander) / (wander.Sum(w => w.Count) + Trust));
        }

        /// <summary>Variance of the samples of one point, whose few samples alone say little.</summary>
        public double NoiseOf(double squares, int count) => (squares + Trust * Noise) / (count - 1 + Trust);
    }
}
