using System;
using System.IO;
using System.Linq;
using UnityEditor;

namespace SphFluid.Validation.Editor
{
    /// <summary>Reads the flags of what makes figures, and opens their folder.</summary>
    static class FigureCommandLine
    {
        /// <summary>Folder of the documentation's pictures.</summary>
        public const string PackageImages = "Packages/com.sphfluid.validation/Documentation~/images";

        const int UsageExitCode = 2;

        /// <summary>Reads the command line of the process; a wrong flag ends the program with exit code 2.</summary>
        /// <param name="names">The experiments.</param>
        /// <param name="picture">Name of an experiment's picture.</param>
        /// <param name="only">The one that is asked for; null for all.</param>
        /// <param name="folder">The folder, which is made; null when none is named.</param>
        public static bool TryRead(string[] names, Func<string, string> picture, out string only, out string folder)
        {
            try
            {
                FigureArguments arguments = FigureArguments.Parse(Environment.GetCommandLineArgs(), names);
                (only, folder) = (arguments.Only, arguments.OutputFolder);
                // The package's own pictures are replaced; they are under version control.
                if (folder != null && Path.GetFullPath(folder) != Path.GetFullPath(PackageImages))
                    ResultFolder.Open(folder, (only == null ? names : new[] { only }).Select(n => ResultFile.Picture(picture(n))));
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
