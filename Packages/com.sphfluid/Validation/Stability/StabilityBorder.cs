using System;

namespace SphFluid.Validation
{
    /// <summary>A border that theory draws into a map.</summary>
    public sealed class StabilityBorder
    {
        /// <summary>A border x(y).</summary>
        /// <param name="title">What it is.</param>
        /// <param name="x">Abscissa at an ordinate.</param>
        public StabilityBorder(string title, Func<double, double> x)
        {
            Title = title;
            X = x;
        }

        /// <summary>What it is.</summary>
        public string Title { get; }

        /// <summary>Abscissa at an ordinate.</summary>
        public Func<double, double> X { get; }
    }
}
