using System;

namespace SphFluid.Validation
{
    /// <summary>A border that theory tells and runs measure: a number, the runs about it, and what it should be.</summary>
    public sealed class StabilityLimit
    {
        readonly Func<double, CaseMethod, CaseSetup> build;

        internal StabilityLimit(string name, double kappa, double low, double high, double growth, Func<double, CaseMethod, CaseSetup> build)
        {
            Name = name;
            SupportRatio = kappa;
            TheoryLow = low;
            TheoryHigh = high;
            Growth = growth;
            this.build = build;
        }

        /// <summary>Relative width of a measured border.</summary>
        public const double Tolerance = 0.01;

        /// <summary>Name in tables, for instance "dt·c/R".</summary>
        public string Name { get; }

        /// <summary>κ = R/dx.</summary>
        public double SupportRatio { get; }

        /// <summary>Least value by theory.</summary>
        public double TheoryLow { get; }

        /// <summary>Greatest value by theory.</summary>
        public double TheoryHigh { get; }

        /// <summary>Growth of v_rms that tells unstable runs.</summary>
        public double Growth { get; }

        /// <summary>A search from well below theory to well above.</summary>
        public Bisection Search() => new Bisection(0.6 * TheoryLow, 1.5 * TheoryHigh, Tolerance);

        /// <summary>The run at a value.</summary>
        public CaseSetup Build(double value, CaseMethod method) => build(value, method);

        /// <summary>For progress lines.</summary>
        public override string ToString() => FormattableString.Invariant($"{Name}, κ {SupportRatio:G3}");
    }
}
