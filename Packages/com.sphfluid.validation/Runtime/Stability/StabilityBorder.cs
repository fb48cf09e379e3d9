using System;

namespace SphFluid.Validation
{
    /// <summary>A line that theory draws into a map, for the methods that it is of.</summary>
    public sealed class StabilityBorder
    {
        /// <summary>A line x(y).</summary>
        /// <param name="theory">The methods that it is of.</param>
        /// <param name="title">What it is.</param>
        /// <param name="x">Abscissa at an ordinate.</param>
        public StabilityBorder(StabilityTheory theory, string title, Func<double, double> x)
        {
            Theory = theory;
            Title = title;
            X = x;
        }

        /// <summary>A level line.</summary>
        /// <param name="theory">The methods that it is of.</param>
        /// <param name="title">What it is.</param>
        /// <param name="y">Its ordinate.</param>
        public StabilityBorder(StabilityTheory theory, string title, double y)
        {
            Theory = theory;
            Title = title;
            Level = y;
        }

        /// <summary>The methods that it is of.</summary>
        public StabilityTheory Theory { get; }

        /// <summary>What it is.</summary>
        public string Title { get; }

        /// <summary>Abscissa at an ordinate; null for a level line.</summary>
        public Func<double, double> X { get; }

        /// <summary>Ordinate of a level line.</summary>
        public double Level { get; }
    }
}
