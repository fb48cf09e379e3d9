using System;

namespace SphFluid.Validation
{
    /// <summary>
    /// Finds the border between what is stable and what is not, by trials: first both ends, then the geometric mean of what is known,
    /// until high/low is below 1 + tolerance.
    /// </summary>
    public sealed class Bisection
    {
        private readonly double tolerance;
        private bool lowKnown, highKnown;

        /// <summary>A search between two values.</summary>
        /// <param name="low">Expected to be stable.</param>
        /// <param name="high">Expected not to be.</param>
        /// <param name="tolerance">Relative width at which it ends.</param>
        public Bisection(double low, double high, double tolerance)
        {
            if (!(low > 0.0) || !(high > low) || !(tolerance > 0.0))
            {
                throw new ArgumentException(
                    FormattableString.Invariant($"A bisection needs 0 < low < high and a tolerance above zero, found {low}, {high} and ") +
                    FormattableString.Invariant($"{tolerance}."));
            }
            Low = low;
            High = high;
            this.tolerance = tolerance;
        }

        /// <summary>Greatest value that was stable; zero when not even the lower end was.</summary>
        public double Low { get; private set; }

        /// <summary>Least value that was not stable; infinite when even the upper end was.</summary>
        public double High { get; private set; }

        /// <summary>Whether the border is known, or lies outside.</summary>
        public bool IsDone { get; private set; }

        /// <summary>Trials so far.</summary>
        public int Trials { get; private set; }

        /// <summary>The value to try next.</summary>
        public double Next => !lowKnown ? Low : !highKnown ? High : Math.Sqrt(Low * High);

        /// <summary>Takes the outcome at <see cref="Next"/>.</summary>
        /// <param name="stable">Whether it was stable.</param>
        public void Add(bool stable)
        {
            if (IsDone) throw new InvalidOperationException("The bisection is done.");
            Trials++;
            if (!lowKnown)
            {
                lowKnown = true;
                if (!stable) (High, Low, IsDone) = (Low, 0.0, true);
                return;
            }
            if (!highKnown)
            {
                highKnown = true;
                if (stable) (Low, High, IsDone) = (High, double.PositiveInfinity, true);
            }
            else if (stable)
            {
                Low = Next;
            }
            else
            {
                High = Next;
            }
            IsDone |= High / Low <= 1.0 + tolerance;
        }
    }
}
