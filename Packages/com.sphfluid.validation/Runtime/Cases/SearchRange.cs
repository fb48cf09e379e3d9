using System;

namespace SphFluid.Validation
{
    /// <summary>
    /// Where a case's fit seeks a quantity. Fits seek beyond it too: a best value at a bound or outside is where the search was stopped,
    /// and no result.
    /// </summary>
    internal sealed class SearchRange
    {
        // Of the range: what is nearer to a bound lies at it.
        private const double Margin = 1e-3;

        private readonly string validationCase, quantity, cure;

        /// <param name="validationCase">Name of the case.</param>
        /// <param name="quantity">What is sought, with its unit: "the front's shift in T".</param>
        /// <param name="low">Lower bound.</param>
        /// <param name="high">Upper bound.</param>
        /// <param name="cure">What the reader of the message can do, a sentence.</param>
        public SearchRange(string validationCase, string quantity, double low, double high, string cure)
        {
            this.validationCase = validationCase;
            this.quantity = quantity;
            this.cure = cure;
            Low = low;
            High = high;
        }

        /// <summary>Lower bound.</summary>
        public double Low { get; }

        /// <summary>Upper bound.</summary>
        public double High { get; }

        /// <summary>Whether a best value is a result: within the bounds, and not at one.</summary>
        public bool Contains(double value) => value > Low + Margin * (High - Low) && value < High - Margin * (High - Low);

        /// <summary>The value, where it is a result or not a number, as nothing was found.</summary>
        /// <exception cref="SearchBoundException">It lies at a bound or outside.</exception>
        public double Require(double value)
        {
            if (double.IsNaN(value) || Contains(value)) return value;
            double bound = value < 0.5 * (Low + High) ? Low : High;
            throw new SearchBoundException(FormattableString.Invariant(
                $"{validationCase}: {quantity} is sought from {Low:G3} to {High:G3}, and the best value, {value:G4}, lies at or beyond ") +
                FormattableString.Invariant($"the bound {bound:G3}. {cure}"));
        }
    }
}
