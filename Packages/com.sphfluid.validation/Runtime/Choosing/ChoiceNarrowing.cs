using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>Which runs would narrow what is expected of an option, where it is too wide to choose by.</summary>
    internal static class ChoiceNarrowing
    {
        /// <summary>An interval whose ends differ by more than this factor says little.</summary>
        public const double Widest = 4.0;

        // At the very point; more seeds than these change nothing.
        private const int SeedsAtOnce = 3, MostSeeds = 9;

        /// <summary>
        /// How wide the wider of an option's intervals is: upper over lower end, errors below the reference's floor counted as one.
        /// </summary>
        public static double Width(ChoiceOption option, ValidationCase validationCase)
        {
            double low = System.Math.Max(option.Error.Low, validationCase.Floor);
            return System.Math.Max(System.Math.Max(low, option.Error.High) / low, option.Milliseconds.High / option.Milliseconds.Low);
        }

        /// <summary>Whether an option's intervals are too wide.</summary>
        public static bool IsWide(ChoiceOption option, ValidationCase validationCase) => Width(option, validationCase) > Widest;

        /// <summary>
        /// The runs of the very point with seeds that it has not yet; none where its interval is narrow, or where it is as wide as its own
        /// runs scatter.
        /// </summary>
        public static IReadOnlyList<ChartRun> Runs(ChoiceOption option, ValidationCase validationCase)
        {
            IReadOnlyList<int> known = option.Curve.Points.FirstOrDefault(p => p.Resolution == option.Resolution)?.Seeds ?? new int[0];
            if (!IsWide(option, validationCase) || known.Count >= MostSeeds) return new ChartRun[0];
            return Enumerable.Range(1, MostSeeds + SeedsAtOnce).Except(known).Take(SeedsAtOnce)
                .Select(seed => new ChartRun(option.ConfigOf(validationCase), seed)).ToList();
        }
    }
}
