using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// The error of a case with one method, κ and speed of sound, against the number of particles along the case's length. What is
    /// predicted never falls with a coarser spacing: a coarse point that errs less than a finer one is right by chance. Its own value is
    /// the interval's lower end.
    /// </summary>
    internal sealed class ErrorCurve
    {
        private readonly LogCurve measured, envelope;
        private readonly double floor;
        private readonly List<(double Low, double High)> gaps = new List<(double, double)>();
        private CurveSpread spread = ErrorModel.Expected;

        /// <summary>A curve.</summary>
        /// <param name="samples">Resolution and errors of the seeds of every point without a failed run.</param>
        /// <param name="failed">Resolutions at which a run failed.</param>
        /// <param name="floor">Errors below this are below what the reference is good for.</param>
        public ErrorCurve(IReadOnlyList<(double Resolution, IReadOnlyList<double> Errors)> samples, IReadOnlyList<double> failed,
            double floor)
        {
            this.floor = floor;
            measured = LogCurve.Of(samples);
            envelope = measured.Envelope();
            List<double> whole = samples.Select(s => s.Resolution).OrderBy(r => r).ToList();
            foreach (double resolution in failed)
            {
                gaps.Add((whole.LastOrDefault(r => r < resolution),
                    whole.Where(r => r > resolution).DefaultIfEmpty(double.PositiveInfinity).First()));
            }
        }

        /// <summary>The measured curve.</summary>
        public LogCurve Measured => measured;

        /// <summary>Standard deviation of a seed's logarithm, as the case's curves show it together.</summary>
        public double Scatter => Math.Sqrt(spread.Noise);

        /// <summary>Standard deviation that the logarithm gains over a way by a factor e.</summary>
        public double Wander => Math.Sqrt(spread.Wander);

        /// <summary>Takes over what the case's curves show together.</summary>
        public void Learn(in CurveSpread shared) => spread = shared;

        /// <summary>Whether a resolution lies within what was measured, and not beside one at which a run failed.</summary>
        public bool Covers(double resolution) => !measured.IsEmpty && resolution > measured.First * 0.999 &&
            resolution < measured.Last * 1.001 &&
            !gaps.Exists(g => resolution > g.Low && resolution < g.High);

        /// <summary>The error that a run of another seed will have.</summary>
        public Estimate At(double resolution)
        {
            double deviation = Math.Sqrt(measured.VarianceAt(resolution, spread));
            Estimate raw = Estimate.OfLogarithm(measured.At(resolution), deviation),
                raised = Estimate.OfLogarithm(envelope.At(resolution), deviation);
            return new Estimate(Math.Max(floor, raised.Value), raw.Low, Math.Max(floor, raised.High));
        }
    }
}
