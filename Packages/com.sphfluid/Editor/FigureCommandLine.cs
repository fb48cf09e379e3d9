using System;
using SphFluid.Validation;
using UnityEditor;

namespace SphFluid.Editor
{
    /// <summary>Reads the flags of what makes figures.</summary>
    static class FigureCommandLine
    {
        const int UsageExitCode = 2;

        /// <summary>Reads the command line of the process; a wrong flag ends the program with exit code 2.</summary>
        /// <param name="verb">For messages.</param>
        /// <param name="names">The experiments.</param>
        /// <param name="only">The one that is asked for; null for all.</param>
        /// <param name="folder">The folder; null when none is named.</param>
        public static bool TryRead(string verb, string[] names, out string only, out string folder)
        {
            try
            {
                (only, folder) = FigureArguments.Parse(Environment.GetCommandLineArgs(), verb, names);
                return true;
            }
            catch (CommandLineException exception)
            {
                (only, folder) = (null, null);
                Console.Error.WriteLine(exception.Message);
                EditorApplication.Exit(UsageExitCode);
                return false;
            }
        }
    }
}
