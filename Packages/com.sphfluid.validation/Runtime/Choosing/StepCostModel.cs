using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// The GPU time of a step of a method on a device: t = f + N (a + b κ³) + s S(N). f is what a step costs whatever the number of
    /// particles: dispatches, and on a graphics card its idle time; a is a particle's own work, b that with its neighbours, of whom there
    /// are about κ³ as many. S is the thesis's bitonic sort of the next power of two, P log₂P (log₂P + 1)/2 exchanges; other methods have
    /// none.
    /// </summary>
    public sealed class StepCostModel
    {
        // Relative residuals beyond this many of their median count less (P. J. Huber 1964).
        private const double Huber = 1.345 * 1.4826;
        private const int Rounds = 4;

        private readonly bool sorts;

        private StepCostModel(bool sorts, double[] coefficients, double[] errors, double deviation, int least, int most)
        {
            this.sorts = sorts;
            Coefficients = coefficients;
            Errors = errors;
            Deviation = deviation;
            (LeastParticles, MostParticles) = (least, most);
        }

        /// <summary>f [ms], a [ms], b [ms] and s [ms].</summary>
        public IReadOnlyList<double> Coefficients { get; }

        /// <summary>Standard errors of the coefficients, by leaving out a sample at a time [ms].</summary>
        public IReadOnlyList<double> Errors { get; }

        /// <summary>Standard deviation of the logarithm of measured over fitted times.</summary>
        public double Deviation { get; }

        /// <summary>Fewest particles of the samples.</summary>
        public int LeastParticles { get; }

        /// <summary>Most particles of the samples.</summary>
        public int MostParticles { get; }

        /// <summary>A fit of times.</summary>
        /// <param name="method">The method.</param>
        /// <param name="samples">Number of particles, κ and time of a step [ms].</param>
        /// <exception cref="ArgumentException">There are no samples.</exception>
        public static StepCostModel Fit(FluidMethodKind method,
            IReadOnlyList<(int Particles, double SupportRatio, double Milliseconds)> samples)
        {
            bool sorts = method == FluidMethodKind.Thesis || method == FluidMethodKind.ThesisPrinted;
            List<double[]> terms = samples.Select(s => Terms(sorts, s.Particles, s.SupportRatio)).ToList();
            List<double> times = samples.Select(s => s.Milliseconds).ToList();
            double[] fit = Robust(terms, times);
            List<double> residuals = terms.Select((t, i) => Math.Log(times[i] / Math.Max(1e-12, NonnegativeFit.Dot(t, fit)))).ToList();
            int freedom = Math.Max(1, samples.Count - fit.Count(c => c > 0.0));
            return new StepCostModel(sorts, fit, Jackknife(terms, times, fit), Math.Sqrt(residuals.Sum(r => r * r) / freedom),
                samples.Min(s => s.Particles), samples.Max(s => s.Particles));
        }

        /// <summary>Time of a step [ms].</summary>
        /// <param name="particles">Number of particles.</param>
        /// <param name="supportRatio">κ = R/dx.</param>
        public double At(double particles, double supportRatio) =>
            NonnegativeFit.Dot(Terms(sorts, particles, supportRatio), Coefficients.ToArray());

        private static double[] Terms(bool sorts, double particles, double supportRatio)
        {
            double length = Math.Ceiling(Math.Log(Math.Max(2.0, particles), 2.0) - 1e-9);
            return new[] { 1.0, particles, particles * supportRatio * supportRatio * supportRatio,
                sorts ? Math.Pow(2.0, length) * length * (length + 1.0) / 2.0 : 0.0 };
        }

        // Relative residuals count alike, and those that something disturbed less.
        private static double[] Robust(List<double[]> terms, List<double> times)
        {
            List<double> weights = times.Select(t => 1.0 / (t * t)).ToList();
            double[] fit = NonnegativeFit.Solve(terms, times, weights);
            for (int round = 1; round < Rounds && terms.Count > fit.Length; round++)
            {
                List<double> off = terms.Select((t, i) => Math.Abs(NonnegativeFit.Dot(t, fit) / times[i] - 1.0)).ToList();
                double limit = Huber * Math.Max(1e-6, StepTimes.Quantile(off.OrderBy(o => o).ToList(), 0.5));
                weights = times.Select((t, i) => Math.Min(1.0, limit / Math.Max(1e-12, off[i])) / (t * t)).ToList();
                fit = NonnegativeFit.Solve(terms, times, weights);
            }
            return fit;
        }

        private static double[] Jackknife(List<double[]> terms, List<double> times, double[] fit)
        {
            int count = terms.Count;
            var squares = new double[fit.Length];
            for (int left = 0; left < count && count > 1; left++)
            {
                double[] without = Robust(terms.Where((_, i) => i != left).ToList(), times.Where((_, i) => i != left).ToList());
                for (int j = 0; j < fit.Length; j++) squares[j] += (without[j] - fit[j]) * (without[j] - fit[j]);
            }
            return squares.Select(s => Math.Sqrt(s * (count - 1) / count)).ToArray();
        }
    }
}
