using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// How many particles deep water must be for an error of its waves, by a chart: the numbers behind the inspector's error class.
    /// </summary>
    internal sealed class DepthClasses
    {
        private DepthClasses(double supportRatio, int coarsest, int finest, IReadOnlyList<int> depths)
        {
            SupportRatio = supportRatio;
            Coarsest = coarsest;
            Finest = finest;
            Depths = depths;
        }

        /// <summary>κ = R/dx.</summary>
        public double SupportRatio { get; }

        /// <summary>Fewest particles of depth that were measured.</summary>
        public int Coarsest { get; }

        /// <summary>Most particles of depth that were measured.</summary>
        public int Finest { get; }

        /// <summary>Fewest particles of depth with each error or less; 0 where none was measured.</summary>
        public IReadOnlyList<int> Depths { get; }

        /// <summary>The depths of a method, for each κ at the base's speed of sound.</summary>
        /// <param name="chart">The chart.</param>
        /// <param name="method">The method.</param>
        /// <param name="limits">The errors.</param>
        public static IReadOnlyList<DepthClasses> Of(ChartData chart, CaseMethod method, IReadOnlyList<double> limits)
        {
            var wave = new StandingWaveCase();
            double ratio = wave.Base(method).SoundSpeedRatio;
            return ErrorModel.Of(chart, new ValidationCase[] { wave }).SelectMany(m => m.Curves)
                .Where(c => c.First.Method == method.Name && c.First.SoundSpeedRatio.Equals(ratio)).OrderBy(c => c.First.SupportRatio)
                .Select(curve =>
                {
                    List<int> covered = Enumerable.Range(curve.Points[0].Resolution,
                        curve.Points[curve.Points.Count - 1].Resolution - curve.Points[0].Resolution + 1)
                        .Where(n => curve.Error.Covers(n)).ToList();
                    return new DepthClasses(curve.First.SupportRatio, covered[0], covered[covered.Count - 1],
                        limits.Select(limit => covered.FirstOrDefault(n => curve.Error.At(n).Value <= limit)).ToList());
                }).ToList();
        }
    }
}
