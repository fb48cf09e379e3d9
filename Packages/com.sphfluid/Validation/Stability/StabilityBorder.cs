using System;

namespace SphFluid.Validation
{
    /// <summary>A line that theory draws into a map.</summary>
    public sealed class StabilityBorder
    {
        /// <summary>A line x(y).</summary>
        /// <param name="title">What it is.</param>
        /// <param name="x">Abscissa at an ordinate.</param>
        public StabilityBorder(string title, Func<double, double> x)
        {
            Title = title;
            X = x;
        }

        /// <summary>A level line.</summary>
        /// <param name="title">What it is.</param>
        /// <param name="y">Its ordinate.</param>
        public StabilityBorder(string title, double y)
        {
            Title = title;
            Level = y;
        }

        /// <summary>What it is.</summary>
        public string Title { get; }

        /// <summary>Abscissa at an ordinate; null for a level line.</summary>
        public Func<double, double> X { get; }

        /// <summary>Ordinate of a level line.</summary>
        public double Level { get; }
    }
}
