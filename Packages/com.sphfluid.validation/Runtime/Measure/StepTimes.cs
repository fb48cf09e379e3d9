using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// The time of a step over a run, and how far it can be trusted. The run is divided into parts of about as many steps; of the parts'
    /// means the median is the time, and the quartiles are its bar. A disturbance that lasts for a part or two does not move the median,
    /// and steps that differ in turn, as those with and without a sort, are together in every part.
    /// </summary>
    public readonly struct StepTimes
    {
        /// <summary>
        /// A spread above this says that the device was busy with something else, or that the flow's cost changed by as much.
        /// </summary>
        public const double BusySpread = 0.25;

        private const int MostParts = 9;

        private StepTimes(double median, double low, double high, double mean)
        {
            Median = median;
            Low = low;
            High = high;
            Mean = mean;
        }

        /// <summary>No times: none of them is a number.</summary>
        public static StepTimes None { get; } = new StepTimes(double.NaN, double.NaN, double.NaN, double.NaN);

        /// <summary>Median of the parts [ms].</summary>
        public double Median { get; }

        /// <summary>Lower quartile of the parts [ms].</summary>
        public double Low { get; }

        /// <summary>Upper quartile of the parts [ms].</summary>
        public double High { get; }

        /// <summary>All time over all steps [ms].</summary>
        public double Mean { get; }

        /// <summary>The quartiles' distance over the median.</summary>
        public double Spread => (High - Low) / Median;

        /// <summary>Of submissions that had some steps each: times of 2, 2 and 8 ms with 1, 1 and 4 steps are 2 ms a step.</summary>
        /// <param name="milliseconds">Time of each submission [ms].</param>
        /// <param name="steps">Steps of each.</param>
        /// <param name="mostParts">Parts into which the run is divided at most.</param>
        /// <exception cref="ArgumentException">There are not as many times as submissions.</exception>
        public static StepTimes Of(IReadOnlyList<double> milliseconds, IReadOnlyList<int> steps, int mostParts = MostParts)
        {
            if (milliseconds.Count != steps.Count)
            {
                throw new ArgumentException($"There are {milliseconds.Count} times of {steps.Count} submissions.", nameof(milliseconds));
            }
            long all = steps.Sum(s => (long)s);
            if (all == 0) return None;
            var means = new List<double>();
            double part = (double)all / Math.Min(mostParts, steps.Count), time = 0.0;
            long count = 0, done = 0;
            for (int i = 0; i < steps.Count; i++)
            {
                time += milliseconds[i];
                count += steps[i];
                done += steps[i];
                // Half a part that is left over belongs to the last one.
                if (done < all && (done < (means.Count + 1) * part - 1e-9 || all - done < 0.5 * part)) continue;
                means.Add(time / count);
                (time, count) = (0.0, 0);
            }
            means.Sort();
            return new StepTimes(Quantile(means, 0.5), Quantile(means, 0.25), Quantile(means, 0.75), milliseconds.Sum() / all);
        }

        /// <summary>Of a run whose submissions were not timed one by one: the mean alone.</summary>
        /// <param name="milliseconds">All time [ms].</param>
        /// <param name="steps">All steps.</param>
        public static StepTimes Whole(double milliseconds, long steps)
        {
            double mean = steps > 0 ? milliseconds / steps : double.NaN;
            return new StepTimes(mean, double.NaN, double.NaN, mean);
        }

        /// <summary>A quantile of sorted samples, interpolated: the quarter of 0, 1, 2, 3, 4 is 1, that of 0, 2 is 0.5.</summary>
        internal static double Quantile(IReadOnlyList<double> sorted, double share)
        {
            double place = share * (sorted.Count - 1);
            int below = Math.Min(sorted.Count - 1, (int)place), above = Math.Min(sorted.Count - 1, below + 1);
            return sorted[below] + (place - below) * (sorted[above] - sorted[below]);
        }
    }
}
