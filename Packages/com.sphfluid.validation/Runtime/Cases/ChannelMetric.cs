using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>Holds the particles' velocities along x against a profile over y at given times.</summary>
    public sealed class ChannelMetric : CaseMetric
    {
        private const int ReferencePoints = 41;

        private readonly double gap, maxSpeed, interval;
        private readonly int bins;
        private readonly Func<double, double, double> reference;
        private readonly double[] times;
        private readonly double[] errors;
        private readonly double[] relative;
        private readonly double[] across;
        private readonly List<CaseSeries> series = new List<CaseSeries>();
        private int taken;

        /// <summary>A metric for one run.</summary>
        /// <param name="gap">Distance of the walls, y = −gap/2 and gap/2 [m].</param>
        /// <param name="maxSpeed">Fastest speed of the flow [m/s]: the unit of the errors.</param>
        /// <param name="reference">u [m/s] at a distance from the lower wall [m] and a time [s].</param>
        /// <param name="times">Times at which it is measured [s], ascending.</param>
        /// <param name="interval">Time between samples [s]: the sample nearest to each time counts, with the reference at its own
        /// time.</param>
        /// <param name="bins">Points of the measured curves.</param>
        public ChannelMetric(double gap, double maxSpeed, Func<double, double, double> reference, double[] times, double interval, int bins)
        {
            this.gap = gap;
            this.maxSpeed = maxSpeed;
            this.reference = reference;
            this.times = times;
            this.interval = interval;
            this.bins = bins;
            errors = new double[times.Length];
            relative = new double[times.Length];
            across = new double[times.Length];
        }

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
            if (taken == times.Length || time < times[taken] - 0.5 * interval) return;
            double squares = 0.0, crossing = 0.0, exact = 0.0;
            var sums = new double[bins];
            var counts = new int[bins];
            for (int i = 0; i < state.Count; i++)
            {
                double y = state.LocalPositions[i].y + 0.5 * gap;
                double u = reference(y, time);
                double error = state.Velocities[i].x - u;
                squares += error * error;
                exact += u * u;
                crossing += (double)state.Velocities[i].y * state.Velocities[i].y + (double)state.Velocities[i].z * state.Velocities[i].z;
                int bin = Math.Min(bins - 1, Math.Max(0, (int)(y / gap * bins)));
                sums[bin] += state.Velocities[i].x;
                counts[bin]++;
            }
            errors[taken] = Math.Sqrt(squares / state.Count) / maxSpeed;
            relative[taken] = Math.Sqrt(squares / exact);
            across[taken] = Math.Sqrt(crossing / state.Count) / maxSpeed;
            AddCurves(time, sums, counts);
            taken++;
        }

        /// <summary>
        /// The largest error of the times, then each; the last over the exact profile's own norm; the flow across the channel.
        /// </summary>
        public override IReadOnlyList<CaseError> Evaluate()
        {
            bool all = taken == times.Length;
            double largest = 0.0, crossing = 0.0;
            var result = new List<CaseError>();
            for (int k = 0; k < times.Length; k++)
            {
                result.Add(new CaseError($"profile, L2/u_max at t = {times[k]:0.##} s", k < taken ? errors[k] : double.NaN));
                largest = Math.Max(largest, errors[k]);
                crossing = Math.Max(crossing, across[k]);
            }
            result.Insert(0, new CaseError(ErrorName, all ? largest : double.NaN));
            result.Add(new CaseError("profile at the end, relative L2", all ? relative[times.Length - 1] : double.NaN));
            result.Add(new CaseError("flow across the channel, RMS/u_max", all ? crossing : double.NaN));
            return result;
        }

        /// <inheritdoc/>
        public override IReadOnlyList<CaseSeries> Series() => series;

        internal const string ErrorName = "profile, largest L2/u_max";

        private void AddCurves(double time, double[] sums, int[] counts)
        {
            var exact = new CaseSeries($"exact, t = {times[taken]:0.##} s", true);
            for (int i = 0; i < ReferencePoints; i++)
            {
                double y = gap * i / (ReferencePoints - 1);
                exact.Add(y / gap, reference(y, time) / maxSpeed);
            }
            var measured = new CaseSeries($"t = {times[taken]:0.##} s");
            for (int b = 0; b < bins; b++)
            {
                if (counts[b] > 0) measured.Add((b + 0.5) / bins, sums[b] / counts[b] / maxSpeed);
            }
            series.Add(exact);
            series.Add(measured);
        }
    }
}
