using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>
    /// Samples of a quantity over time, each with the integral over its own span, and exact means over the last part of it.
    /// </summary>
    internal sealed class TimeMean
    {
        private readonly List<(double Time, double Length, double Integral)> samples =
            new List<(double Time, double Length, double Integral)>();
        private int first; // of those that are kept

        /// <summary>How far back samples are kept [s]: as long as the longest mean that is asked for.</summary>
        public double Memory { get; set; } = 1.0;

        /// <summary>Number of samples that are kept.</summary>
        public int Count => samples.Count - first;

        /// <summary>A sample that is kept, 0 the oldest.</summary>
        public (double Time, double Length, double Integral) this[int index] => samples[first + index];

        /// <summary>Time at the end of the newest sample [s]; −1 without any.</summary>
        public double Time => Count > 0 ? samples[samples.Count - 1].Time : -1.0;

        /// <summary>Adds a sample.</summary>
        /// <param name="time">Time at its end [s].</param>
        /// <param name="length">Its span [s].</param>
        /// <param name="integral">Integral of the quantity over that.</param>
        public void Add(double time, double length, double integral)
        {
            samples.Add((time, length, integral));
            while (first < samples.Count - 1 && samples[first].Time < time - Memory) first++;
            if (first < 64 || 2 * first < samples.Count) return;
            samples.RemoveRange(0, first);
            first = 0;
        }

        /// <summary>Forgets all samples.</summary>
        public void Clear()
        {
            samples.Clear();
            first = 0;
        }

        /// <summary>Mean over the last seconds; 0 seconds: the last sample alone. 0 without any.</summary>
        public double Mean(double seconds) => Mean(samples.Count, seconds);

        /// <summary>The largest mean that any of the last samples ended; 0 without any.</summary>
        public double Peak(double seconds, long last)
        {
            double peak = double.NegativeInfinity;
            for (int end = samples.Count; end > first && last > 0; end--, last--) peak = Math.Max(peak, Mean(end, seconds));
            return double.IsInfinity(peak) ? 0.0 : peak;
        }

        // Of the samples before one; of the first in the span the part that lies in it.
        private double Mean(int end, double seconds)
        {
            double integral = 0.0, time = 0.0;
            for (int i = end - 1; i >= first && (i == end - 1 || time < seconds); i--)
            {
                double length = samples[i].Length;
                double share = i == end - 1 || !(time + length > seconds) ? 1.0 : (seconds - time) / length;
                integral += share * samples[i].Integral;
                time += share * length;
            }
            return time > 0.0 ? integral / time : 0.0;
        }
    }
}
