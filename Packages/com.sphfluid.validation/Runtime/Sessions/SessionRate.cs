using System;

namespace SphFluid.Validation
{
    /// <summary>How fast jobs go, from those that are done.</summary>
    sealed class SessionRate
    {
        readonly double? expected;
        double cost, seconds;

        /// <param name="expected">Work a second before a job is done; null when it is not known.</param>
        public SessionRate(double? expected) => this.expected = expected;

        /// <summary>Takes a job into account.</summary>
        public void Add(double jobCost, TimeSpan time)
        {
            cost += jobCost;
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
