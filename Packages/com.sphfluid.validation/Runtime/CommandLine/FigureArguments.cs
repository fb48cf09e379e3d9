using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>Which pictures <c>figures</c> makes and where it writes.</summary>
    internal sealed class FigureArguments : MeasuringArguments
    {
        internal FigureArguments(string[] names) : base("figures", null)
        {
            Options.Add("--only", "NAME", "this picture only (a wrong name lists them)", "all", names, flag => Only = flag.OneOf(names));
            AddFolder("Packages/com.sphfluid.validation/Documentation~/images");
        }

        /// <summary>The experiment that is asked for; null for all.</summary>
        public string Only { get; private set; }

        /// <summary>Reads the command line of the process.</summary>
        /// <param name="commandLine">The words.</param>
        /// <param name="names">The experiments.</param>
        /// <exception cref="CommandLineException">A flag is unknown, or a value is missing or wrong.</exception>
        public static FigureArguments Parse(IReadOnlyList<string> commandLine, string[] names)
        {
            var result = new FigureArguments(names);
            result.Read(commandLine);
            return result;
        }
    }
}
