using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A liquid whose step is timed: a method, κ and a number of particles.</summary>
    public sealed class StepCostPoint
    {
        // Two numbers lie just above a power of two, to which the thesis's sort pads.
        private static readonly int[] software = { 500, 1000, 1100, 2000, 4000, 4200, 8000, 16000, 32000 };
        private static readonly int[] card = { 1000, 1100, 2000, 4000, 16000, 64000, 66000, 256000, 1000000 };
        private static readonly int[] quick = { 500, 1100, 4000, 16000 };

        /// <summary>A liquid.</summary>
        /// <param name="method">The method.</param>
        /// <param name="supportRatio">κ = R/dx.</param>
        /// <param name="particles">Number of particles.</param>
        public StepCostPoint(CaseMethod method, double supportRatio, int particles)
        {
            Method = method;
            SupportRatio = supportRatio;
            Particles = particles;
        }

        /// <summary>The method.</summary>
        public CaseMethod Method { get; }

        /// <summary>κ = R/dx.</summary>
        public double SupportRatio { get; }

        /// <summary>Number of particles.</summary>
        public int Particles { get; }

        /// <summary>Equal for equal liquids.</summary>
        public string Key => KeyOf(Method.Name, SupportRatio, Particles);

        /// <summary>
        /// The liquids of a chart: from few particles, where a step's own cost is all, to as many as the device does in a second or two.
        /// </summary>
        /// <param name="methods">The methods; references have no use for them.</param>
        /// <param name="isQuick">Whether only κ of the bases, with fewer numbers, is timed.</param>
        /// <param name="isSoftware">Whether the device is a CPU.</param>
        public static IReadOnlyList<StepCostPoint> Of(IEnumerable<CaseMethod> methods, bool isQuick, bool isSoftware) =>
            (from method in methods
             where !method.IsReference
             from ratio in isQuick ? new[] { method.SupportRatio } : ChartSweep.IsOffered(method) ? new[] { 2.0, 2.25, 2.5 }
                 : new[] { 2.0, 2.5 }
             from count in isQuick ? quick : isSoftware ? software : card
             select new StepCostPoint(method, ratio, count)).ToList();

        /// <summary>For progress lines.</summary>
        public override string ToString() =>
            string.Format(CultureInfo.InvariantCulture, "step of {0}, κ {1:G4}, {2:N0} particles", Method.Name, SupportRatio, Particles);

        internal static string KeyOf(string method, double supportRatio, int particles) =>
            $"{method}|{CsvText.Text(supportRatio)}|{particles}";
    }
}
