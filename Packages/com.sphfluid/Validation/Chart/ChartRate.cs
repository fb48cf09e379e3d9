using System;

namespace SphFluid.Validation
{
    /// <summary>How fast runs go, from those that are done.</summary>
    sealed class ChartRate
    {
        readonly double? expected;
        double cost, seconds;

        /// <param name="expected">Work a second before a run is done; null when it is not known.</param>
        public ChartRate(double? expected) => this.expected = expected;

        /// <summary>Takes a run into account.</summary>
        public void Add(double runCost, TimeSpan time)
        {
            cost += runCost;
            seconds += time.TotalSeconds;
        }

        /// <summary>Time that some work will take; null while that is not known.</summary>
        public TimeSpan? TimeFor(double work)
        {
            double? rate = cost > 0.0 && seconds > 0.0 ? cost / seconds : expected;
            return rate.HasValue ? TimeSpan.FromSeconds(work / rate.Value) : (TimeSpan?)null;
        }
    }
}
