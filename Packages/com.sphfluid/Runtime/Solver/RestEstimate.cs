using System;

namespace SphFluid
{
    /// <summary>
    /// Simulated time until a liquid is at rest. What accelerates it falls about as e^(-rate t) while it settles; the rate is taken
    /// over the last crossing of sound.
    /// </summary>
    internal sealed class RestEstimate
    {
        private readonly double crossing, settle, flow;
        private double windowStart, windowLog = double.NaN, rate = double.NaN;

        /// <param name="crossing">Time that sound takes through the liquid [s].</param>
        /// <param name="settle">Longest time of settling [s].</param>
        /// <param name="flow">Time of flowing, where settling is not enough [s]; 0 without gravity.</param>
        public RestEstimate(double crossing, double settle, double flow)
        {
            this.crossing = crossing;
            this.settle = settle;
            this.flow = flow;
        }

        /// <summary>Time left while the liquid settles [s].</summary>
        /// <param name="time">Time since settling began [s].</param>
        /// <param name="excess">Largest acceleration over the one that may be left.</param>
        public double Settling(double time, double excess)
        {
            AddSample(time, Math.Log(Math.Max(excess, 1e-6)));
            double atLeast = Math.Max(0.0, crossing - time), most = Math.Max(0.0, settle - time);
            if (excess <= 1.0) return atLeast;
            double needed = double.IsNaN(rate) ? most : rate > 0.0 ? Math.Log(excess) / rate : double.PositiveInfinity;
            if (needed <= most) return Math.Max(atLeast, needed);
            return flow > 0.0 ? most + FlowAndSettle(0.0) : most;
        }

        /// <summary>Time left while it flows [s]: the flow, and half of the longest time to settle again.</summary>
        /// <param name="time">Time since flowing began [s].</param>
        public double Flowing(double time)
        {
            (windowLog, rate) = (double.NaN, double.NaN);
            return FlowAndSettle(time);
        }

        private double FlowAndSettle(double time) => Math.Max(0.0, flow - time) + 0.5 * settle;

        private void AddSample(double time, double log)
        {
            if (double.IsNaN(windowLog) || time < windowStart)
            {
                (windowStart, windowLog) = (time, log);
                return;
            }
            double length = time - windowStart;
            if (length < 0.25 * crossing) return;
            rate = (windowLog - log) / length;
            if (length > crossing) (windowStart, windowLog) = (time, log);
        }
    }
}
