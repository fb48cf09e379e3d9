using System.Collections.Generic;
using static System.FormattableString;

namespace SphFluid.Editor
{
    /// <summary>
    /// How wrong a liquid's waves are at best, by how many particles deep it is: the error of a standing wave's period, the case
    /// standing-wave of the validation package. A: up to 2 %, B: up to 5 %, C: up to 10 %, D: more. Other motion errs otherwise; the class
    /// is for comparing spacings.
    /// </summary>
    public static class ErrorClass
    {
        /// <summary>Largest error of the classes A, B and C.</summary>
        public static readonly IReadOnlyList<double> Limits = new[] { 0.02, 0.05, 0.1 };

        /// <summary>
        /// The chart in the repository that the numbers come from: <c>ErrorClassTests</c> of the validation package compares them.
        /// </summary>
        public const string Chart = "benchmarks/accuracy/llvmpipe-2026-11-25";

        /// <summary>What was measured of a method with a κ.</summary>
        public readonly struct Row
        {
            /// <summary>A row.</summary>
            /// <param name="method">The method.</param>
            /// <param name="supportRatio">κ = R/dx.</param>
            /// <param name="coarsest">Fewest particles of depth that were measured.</param>
            /// <param name="finest">Most particles of depth that were measured.</param>
            /// <param name="depths">Fewest particles of depth of the classes A, B and C; 0 for none.</param>
            public Row(FluidMethodKind method, double supportRatio, int coarsest, int finest, params int[] depths)
            {
                Method = method;
                SupportRatio = supportRatio;
                Coarsest = coarsest;
                Finest = finest;
                Depths = depths;
            }

            /// <summary>The method.</summary>
            public FluidMethodKind Method { get; }

            /// <summary>κ = R/dx.</summary>
            public double SupportRatio { get; }

            /// <summary>Fewest particles of depth that were measured.</summary>
            public int Coarsest { get; }

            /// <summary>Most particles of depth that were measured.</summary>
            public int Finest { get; }

            /// <summary>Fewest particles of depth of the classes A, B and C; 0 where no depth that was measured has the class.</summary>
            public IReadOnlyList<int> Depths { get; }
        }

        /// <summary>The table.</summary>
        public static readonly IReadOnlyList<Row> Table = new[]
        {
            new Row(FluidMethodKind.Standard, 2.0, 10, 13, 0, 0, 10),
            new Row(FluidMethodKind.Standard, 2.25, 10, 20, 16, 14, 11),
            new Row(FluidMethodKind.Standard, 2.5, 10, 13, 0, 0, 12),
            new Row(FluidMethodKind.Robust, 2.0, 10, 20, 0, 10, 10),
            new Row(FluidMethodKind.Robust, 2.25, 10, 20, 18, 14, 11),
            new Row(FluidMethodKind.Robust, 2.5, 10, 13, 0, 0, 0),
        };

        /// <summary>The class of a liquid in words.</summary>
        /// <param name="method">The method.</param>
        /// <param name="supportRatio">κ = R/dx.</param>
        /// <param name="particles">Particles of depth.</param>
        /// <returns>For instance "B, waves within 5 %: 15 particles deep".</returns>
        public static string Describe(FluidMethodKind method, double supportRatio, double particles)
        {
            string deep = Invariant($"{particles:0.#} particles deep");
            foreach (Row row in Table)
            {
                if (row.Method != method || System.Math.Abs(row.SupportRatio - supportRatio) > 0.01) continue;
                if (particles < 0.95 * row.Coarsest) return $"none: {deep}, and waves were measured with {row.Coarsest} or more";
                string finer = particles > 1.05 * row.Finest ? $", finer than the {row.Finest} that were measured" : "";
                for (int i = 0; i < Limits.Count; i++)
                {
                    if (row.Depths[i] > 0 && particles >= row.Depths[i] - 0.5)
                    {
                        return Invariant($"{(char)('A' + i)}, waves within {100.0 * Limits[i]:0} %: {deep}{finer}");
                    }
                }
                return Invariant($"D, waves wrong by more than {100.0 * Limits[Limits.Count - 1]:0} %: {deep}");
            }
            return Invariant($"none: waves were not measured with this method at κ = {supportRatio:0.##}; {deep}");
        }
    }
}
