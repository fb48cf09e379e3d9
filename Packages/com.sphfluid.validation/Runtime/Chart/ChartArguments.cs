using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>What <c>chart</c> measures and where it writes.</summary>
    public sealed class ChartArguments : MeasuringArguments
    {
        // However busy the machine is, a quick chart stops after this time.
        private const double QuickMinutes = 9.0;

        private readonly List<ValidationCase> cases = new List<ValidationCase>();
        private readonly List<CaseMethod> methods = new List<CaseMethod>();
        private readonly int chartedCount;

        private ChartArguments(IReadOnlyList<ValidationCase> charted) : base("chart", "Build/chart")
        {
            chartedCount = charted.Count;
            AddQuick("fewer points: below ten minutes on two CPU cores");
            AddChoice("--case", "these cases", "all", cases, charted, c => c.Name);
            AddChoice("--method", "these methods", "all", methods, CaseMethod.All, m => m.Name);
            AddFolder();
            AddSlice("none; 9 with --quick");
            AddShard();
        }

        /// <summary>The cases, none of them a gate.</summary>
        public IReadOnlyList<ValidationCase> Cases => cases;

        /// <summary>The methods.</summary>
        public IReadOnlyList<CaseMethod> Methods => methods;

        internal override string Command => CommandOf(
            ("--case", Cases.Count == chartedCount ? null : Cases.Select(c => c.Name)),
            ("--method", Methods.Count == CaseMethod.All.Count ? null : Methods.Select(m => m.Name)));

        /// <summary>Reads the command line of the process.</summary>
        /// <exception cref="CommandLineException">A flag is unknown, or a value is missing or wrong.</exception>
        public static ChartArguments Parse(IReadOnlyList<string> commandLine) => Parse(commandLine, CaseCatalogue.All);

        internal static ChartArguments Parse(IReadOnlyList<string> commandLine, IReadOnlyList<ValidationCase> known)
        {
            ChartArguments result = Of(known);
            result.Read(commandLine);
            if (result.cases.Count == 0) result.cases.AddRange(Charted(known));
            if (result.methods.Count == 0) result.methods.AddRange(CaseMethod.All);
            if (result.Quick && !result.Slice.HasValue) result.Slice = TimeSpan.FromMinutes(QuickMinutes);
            return result;
        }

        internal static ChartArguments Of(IReadOnlyList<ValidationCase> known) => new ChartArguments(Charted(known));

        private static ValidationCase[] Charted(IReadOnlyList<ValidationCase> known) => known.Where(c => !c.IsGate).ToArray();
    }
}
