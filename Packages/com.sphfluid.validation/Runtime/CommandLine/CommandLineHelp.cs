using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>The flags of the package's verbs, for programs that print help.</summary>
    public static class CommandLineHelp
    {
        /// <summary>The verbs: play, bench, chart, choose, stability, leaks, surfaces, merge, budgets, peers, export and figures.</summary>
        public static IReadOnlyList<string> Verbs
        {
            get;
        } = new[] { "play", "bench", "chart", "choose", "stability", "leaks", "surfaces", "merge", "budgets", "peers", "export",
            "figures" };

        /// <summary>The flags of a verb, as its parser reads them.</summary>
        /// <param name="verb">One of <see cref="Verbs"/>.</param>
        /// <exception cref="ArgumentException">There is no such verb.</exception>
        public static IEnumerable<CommandLineOption> FlagsOf(string verb)
        {
            switch (verb)
            {
                case "play": return new PlayArguments().Options;
                case "bench": return new BenchArguments().Options;
                case "chart": return ChartArguments.Of(CaseCatalogue.All).Options;
                case "choose": return ChooseArguments.Empty().Options;
                case "stability": return new StabilityArguments().Options;
                case "leaks": return new LeakArguments().Options;
                case "surfaces": return new SurfaceArguments().Options;
                case "merge": return new MergeArguments().Options;
                case "budgets": return new BudgetArguments().Options;
                case "export": return new ExportArguments().Options;
                case "peers": return new PeerArguments().Options;
                case "figures": return new FigureArguments(Array.Empty<string>()).Options;
                default: throw new ArgumentException($"'{verb}' is none of {string.Join(", ", Verbs)}.", nameof(verb));
            }
        }
    }
}
