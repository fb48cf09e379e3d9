using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>A flow whose right answer is known: its set-up, its reference and the error against it.</summary>
    public abstract class ValidationCase
    {
        /// <summary>Name on the command line and in tables: lower case, words joined by hyphens.</summary>
        public abstract string Name { get; }

        /// <summary>Title of its panel.</summary>
        public abstract string Title { get; }

        /// <summary>Where the reference comes from.</summary>
        public abstract string Source { get; }

        /// <summary>Name of the main error, the first of its metric.</summary>
        public abstract string ErrorName { get; }

        /// <summary>
        /// Errors below this are below what the reference itself is good for: how far independent solutions or experiments lie apart, or
        /// what it leaves out.
        /// </summary>
        public virtual double Floor => 0.0;

        /// <summary>What the floor is, a phrase: "two experiments lie so far apart"; empty where there is none.</summary>
        public virtual string FloorSource => "";

        /// <summary>True for cases that are either right or wrong: they are tested, and not part of the chart.</summary>
        public virtual bool IsGate => false;

        /// <summary>Largest error of a gate; not a number for others.</summary>
        public virtual double Limit => double.NaN;

        /// <summary>Abscissa and ordinate of the picture of its curves.</summary>
        public virtual (string X, string Y) AxisTitles => ("t [s]", "");

        /// <summary>What a reader of the chart must know before he compares errors, printed below the panel; empty for nothing.</summary>
        public virtual string Caution => "";

        /// <summary>Name of an error that the chart shows beside the main one, in a panel of its own; null for none.</summary>
        public virtual string CompanionErrorName => null;

        /// <summary>
        /// Errors that must be small too where the flow is to be right, with what each is in the right flow: energy, shape, level. An
        /// answer of <c>choose</c> holds them or names them.
        /// </summary>
        public virtual IReadOnlyList<(string Name, double Right)> AlsoHeld => System.Array.Empty<(string, double)>();

        /// <summary>
        /// Words for the kind of flow by which <c>choose</c> finds the case, for instance "splash"; no two cases share one.
        /// </summary>
        public virtual IReadOnlyList<string> Words => System.Array.Empty<string>();

        /// <summary>What <see cref="CaseParameters.Resolution"/> divides, for instance "depth of the water".</summary>
        public virtual string LengthTitle => "length";

        /// <summary>The point about which the chart sweeps.</summary>
        /// <param name="method">The method.</param>
        public abstract CaseParameters Base(CaseMethod method);

        /// <summary>Prepares a run.</summary>
        /// <exception cref="System.ArgumentException">The parameters cannot be run.</exception>
        public abstract CaseSetup Build(in CaseParameters parameters);

        /// <summary>A fresh metric for a run.</summary>
        public abstract CaseMetric CreateMetric(in CaseParameters parameters, CaseSetup setup);
    }
}
