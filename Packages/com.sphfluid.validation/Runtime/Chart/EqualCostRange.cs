using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>Two methods at equal GPU time in one case: the ratios of their errors along both fronts.</summary>
    internal sealed class EqualCostRange
    {
        private EqualCostRange(string validationCase, CaseMethod method, CaseMethod other,
            IReadOnlyList<(double Ratio, double Time, bool IsBound)> places)
        {
            Case = validationCase;
            Method = method;
            Other = other;
            Least = places.Min(p => p.Ratio);
            Greatest = places.Max(p => p.Ratio);
            Shortest = places.Min(p => p.Time);
            Longest = places.Max(p => p.Time);
            Count = places.Count;
            Bounds = places.Count(p => p.IsBound);
        }

        /// <summary>Name of the case.</summary>
        public string Case { get; }

        /// <summary>The method that comes later in <see cref="CaseMethod.All"/>.</summary>
        public CaseMethod Method { get; }

        /// <summary>The other.</summary>
        public CaseMethod Other { get; }

        /// <summary>The least error of <see cref="Method"/> over the other's.</summary>
        public double Least { get; }

        /// <summary>The greatest.</summary>
        public double Greatest { get; }

        /// <summary>The least GPU time compared [ms/s].</summary>
        public double Shortest { get; }

        /// <summary>The greatest.</summary>
        public double Longest { get; }

        /// <summary>How many times were compared.</summary>
        public int Count { get; }

        /// <summary>At how many of them one method has no point as dear, so that its dearest stands for it.</summary>
        public int Bounds { get; }

        /// <summary>The ratios, for instance "0.17 to 0.27".</summary>
        public string Ratios => ReportWords.Digits(Least) == ReportWords.Digits(Greatest)
            ? ReportWords.Digits(Least)
            : $"{ReportWords.Digits(Least)} to {ReportWords.Digits(Greatest)}";

        /// <summary>A range for each case and pair of methods.</summary>
        public static IEnumerable<EqualCostRange> Of(IEnumerable<EqualCost.Comparison> comparisons)
        {
            foreach (var pair in comparisons
                .GroupBy(c => (c.Point.Case, Later: Later(c.Point.Method, c.Other), Earlier: Earlier(c.Point.Method, c.Other))))
            {
                yield return new EqualCostRange(pair.Key.Case, pair.Key.Later, pair.Key.Earlier, pair.Select(c =>
                    (c.Point.Method == pair.Key.Later.Name ? c.Ratio : 1.0 / c.Ratio, c.Point.Cost.Value.Median, c.IsBound)).ToList());
            }
        }

        private static CaseMethod Later(string a, string b) => CaseMethod.All.Last(m => m.Name == a || m.Name == b);

        private static CaseMethod Earlier(string a, string b) => CaseMethod.All.First(m => m.Name == a || m.Name == b);
    }
}
