using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>Median, least and greatest of some samples.</summary>
    public readonly struct SampleStatistics
    {
        private SampleStatistics(double median, double minimum, double maximum)
        {
            Median = median;
            Minimum = minimum;
            Maximum = maximum;
        }

        /// <summary>The middle sample; of an even number the mean of the two in the middle.</summary>
        public double Median { get; }

        /// <summary>Least sample.</summary>
        public double Minimum { get; }

        /// <summary>Greatest sample.</summary>
        public double Maximum { get; }

        /// <summary>Of one sample or more, in any order: 3, 1, 2, 10 have the median 2.5.</summary>
        /// <exception cref="ArgumentException">There is no sample.</exception>
        public static SampleStatistics Of(IReadOnlyCollection<double> samples)
        {
            if (samples.Count == 0) throw new ArgumentException("There is no median of no samples.", nameof(samples));
            var sorted = new List<double>(samples);
            sorted.Sort();
            int middle = sorted.Count / 2;
            double median = sorted.Count % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
            return new SampleStatistics(median, sorted[0], sorted[sorted.Count - 1]);
        }
    }
}
