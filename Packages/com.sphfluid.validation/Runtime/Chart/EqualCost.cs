using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// Methods compared at equal GPU time: the error of each point of a method's own Pareto front, and beside it the other method's error
    /// at the same time, from its own front, between whose points errors are powers of the time. Points that are good by chance are not on
    /// these fronts: those of which a finer spacing, all else equal, errs half as much again, as where an error changes its sign.
    /// </summary>
    public static class EqualCost
    {
        /// <summary>The file.</summary>
        public static readonly TableFormat<Comparison> Format = new TableFormat<Comparison>("equal-cost.csv")
            .Text("case", c => c.Point.Case)
            .Text("error_name", c => c.Point.ErrorName)
            .Text("method", c => c.Point.Method)
            .Number("dx", c => c.Point.Spacing)
            .Number("kappa", c => c.Point.SupportRatio)
            .Number("dt_fraction", c => c.Point.TimeStepFraction)
            .Number("c_or_iterations", c => c.Point.SoundSpeedRatio)
            .Number("gpu_ms_per_sim_s", c => Time(c.Point))
            .Number("error", c => Error(c.Point))
            .Text("other_method", c => c.Other)
            .Number("other_error", c => c.OtherError)
            .Number("ratio", c => c.Ratio)
            .Text("other_is", c => c.IsBound ? "its dearest" : "interpolated")
            .Text("device", c => c.Point.Device)
            .Text("date", c => c.Point.Date);

        private const double ByChance = 1.5;

        /// <summary>A point of a method against another method at the same time.</summary>
        public readonly struct Comparison
        {
            internal Comparison(ChartPoint point, string other, double otherError, bool isBound, double floor)
            {
                Point = point;
                Other = other;
                OtherError = otherError;
                IsBound = isBound;
                Ratio = Math.Max(point.Error.Value.Median, floor) / Math.Max(otherError, floor);
            }

            /// <summary>The method's point.</summary>
            public ChartPoint Point { get; }

            /// <summary>The other method.</summary>
            public string Other { get; }

            /// <summary>The other method's error at the point's time.</summary>
            public double OtherError { get; }

            /// <summary>Whether the other method has no point as dear as this one, so that its error is that of its dearest one.</summary>
            public bool IsBound { get; }

            /// <summary>
            /// The point's error over the other's, neither counted below the reference's floor; below 1 the point is better.
            /// </summary>
            public double Ratio { get; }
        }

        /// <summary>Every point of every method's front against every other method that has a point no dearer than it.</summary>
        /// <param name="points">Points of one error of one case.</param>
        /// <param name="floor">Errors below this are below what the reference is good for.</param>
        public static IReadOnlyList<Comparison> Of(IEnumerable<ChartPoint> points, double floor)
        {
            List<IReadOnlyList<ChartPoint>> fronts = Comparable(points, floor).GroupBy(p => p.Method)
                .Select(own => ParetoFront.Of(own)).Where(f => f.Count > 0).ToList();
            return (from own in fronts
                    from other in fronts
                    where other != own
                    from point in own
                    where Time(point) >= Time(other[0])
                    select new Comparison(point, other[0].Method, ErrorAt(other, Time(point)), Time(point) > Time(other[other.Count - 1]),
                        floor)).ToList();
        }

        /// <summary>The points whose every run has an error and a time, without those that are good by chance.</summary>
        internal static IReadOnlyList<ChartPoint> Comparable(IEnumerable<ChartPoint> points, double floor)
        {
            List<ChartPoint> whole = points.Where(p => p.IsWhole).ToList();
            return whole.Where(p => !whole.Any(finer => finer.Method == p.Method && IsByChance(p, finer, floor))).ToList();
        }

        private static bool IsByChance(ChartPoint point, ChartPoint finer, double floor) =>
            finer.Spacing < point.Spacing && finer.SupportRatio.Equals(point.SupportRatio) &&
                finer.TimeStepFraction.Equals(point.TimeStepFraction) &&
            finer.SoundSpeedRatio.Equals(point.SoundSpeedRatio) && Math.Max(floor, Error(finer)) > ByChance * Math.Max(floor, Error(point));

        // Along the best so far: bars may leave a dearer point on the front whose median is no better.
        private static double ErrorAt(IReadOnlyList<ChartPoint> front, double time)
        {
            double best = Error(front[0]), bestTime = Time(front[0]);
            foreach (ChartPoint next in front)
            {
                if (Error(next) >= best) continue;
                if (Time(next) > time) return Power(bestTime, best, Time(next), Error(next), time);
                (best, bestTime) = (Error(next), Time(next));
            }
            return best;
        }

        // On the straight line through two points of logarithmic axes: at 2 between (1, 0.4) and (4, 0.1) 0.2.
        private static double Power(double t0, double e0, double t1, double e1, double t) =>
            t1 > t0 && e1 > 0.0 ? e0 * Math.Pow(e1 / e0, Math.Log(t / t0) / Math.Log(t1 / t0)) : e1;

        private static double Time(ChartPoint point) => point.Cost.Value.Median;

        private static double Error(ChartPoint point) => point.Error.Value.Median;
    }
}
