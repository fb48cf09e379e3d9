using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>The flags of what makes figures: one experiment, and a folder.</summary>
    static class FigureArguments
    {
        /// <summary>Reads the whole command line of the process.</summary>
        /// <param name="commandLine">The words.</param>
        /// <param name="verb">For messages.</param>
        /// <param name="names">The experiments.</param>
        /// <returns>The experiment that is asked for and the folder, each null when it is not named.</returns>
        /// <exception cref="CommandLineException">A flag is unknown, or a value is missing or wrong.</exception>
        public static (string Only, string Folder) Parse(IReadOnlyList<string> commandLine, string verb, string[] names)
        {
            string only = null, folder = null;
            CommandLineFlag.Read(commandLine, verb, new[] { "--only", "--out" }, flag =>
            {
                if (flag.Name == "--only")
                    only = flag.OneOf(names);
                else
                    folder = flag.Folder();
            });
            return (only, folder);
        }
    }
}
