using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>
    /// How fast jobs go: at first as expected, then more and more as those that were done did. Jobs of a kind are compared with each other
    /// where there are any, else with all.
    /// </summary>
    internal sealed class SessionRate
    {
        // What is expected counts like so much time of measuring: the first job also compiles, and may be a small one.
        private const double TrustInExpected = 4.0, TrustInOthers = 1.0;

        private readonly Dictionary<string, (double Cost, double Seconds)> kinds = new Dictionary<string, (double, double)>();
        private double? expected;
        private (double Cost, double Seconds) all;
        private (string Kind, double Cost, double Seconds) running;

        /// <param name="expected">Work a second before a job is done; null when it is not known.</param>
        public SessionRate(double? expected) => this.expected = expected;

        /// <summary>Sets the work a second before a job is done.</summary>
        public void Expect(double rate) => expected = rate;

        /// <summary>Takes a job into account; jobs of no kind are compared with all.</summary>
        public void Add(double jobCost, TimeSpan time, string kind = "")
        {
            kinds.TryGetValue(kind, out (double Cost, double Seconds) known);
            kinds[kind] = (known.Cost + jobCost, known.Seconds + time.TotalSeconds);
            all = (all.Cost + jobCost, all.Seconds + time.TotalSeconds);
            running = default;
        }

        /// <summary>Takes the part of the running job into account that is done; the next call takes its place.</summary>
        public void Running(double doneCost, TimeSpan time, string kind = "") => running = (kind, doneCost, time.TotalSeconds);

        /// <summary>Time that some work will take; null while that is not known.</summary>
        public TimeSpan? TimeFor(double work, string kind = "")
        {
            double? rate = Blend(all.Cost + running.Cost, all.Seconds + running.Seconds, expected, TrustInExpected);
            if (kind.Length > 0)
            {
                kinds.TryGetValue(kind, out (double Cost, double Seconds) own);
                if (running.Kind == kind) own = (own.Cost + running.Cost, own.Seconds + running.Seconds);
                rate = Blend(own.Cost, own.Seconds, rate, TrustInOthers);
            }
            return rate.HasValue ? TimeSpan.FromSeconds(Math.Min(work / rate.Value, TimeSpan.MaxValue.TotalSeconds / 2)) : (TimeSpan?)null;
        }

        private static double? Blend(double cost, double seconds, double? other, double trust)
        {
            bool measured = cost > 0.0 && seconds > 0.0;
            if (!other.HasValue) return measured ? cost / seconds : (double?)null;
            return measured ? (cost + trust * other.Value) / (seconds + trust) : other;
        }
    }
}
