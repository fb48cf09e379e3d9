using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>Colours and symbols of the chart: a colour a method, a symbol a factor.</summary>
    internal static class ChartStyle
    {
        // M. Okabe and K. Ito's colours, which colour-blind readers can distinguish.
        private static readonly string[] colours = { "#D55E00", "#0072B2", "#CC79A7", "#E69F00", "#009E73", "#56B4E9" };

        /// <summary>The factors in the order of the legend, with gnuplot's filled point types; the open one is the number before.</summary>
        public static readonly IReadOnlyList<(ChartFactor Factor, int Symbol, string Title)> Factors = new[]
        {
            (ChartFactor.Base, 7, "base"),
            (ChartFactor.Spacing, 9, "spacing dx"),
            (ChartFactor.Support, 5, "support κ = R/dx"),
            (ChartFactor.TimeStep, 13, "time step"),
            (ChartFactor.SoundSpeed, 11, "speed of sound"),
            (ChartFactor.Several, 3, "several of them"),
        };

        public static string Colour(int method) => "rgb '" + colours[method % colours.Length] + "'";

        public static int Symbol(ChartFactor factor) => Factors.First(f => f.Factor == factor).Symbol;

        public static string Title(ChartFactor factor) => Factors.First(f => f.Factor == factor).Title;

        public static int OpenSymbol(ChartFactor factor) => Symbol(factor) - 1;

        public static string Size(ChartFactor factor) => factor == ChartFactor.Base ? "1.9" : "1.1";
    }
}
