using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Validation.Editor
{
    /// <summary>Runs experiments that end in figures on the console and a picture each.</summary>
    internal static class FigureSession
    {
        /// <summary>Folder of the documentation's pictures.</summary>
        public const string PackageImages = "Packages/com.sphfluid.validation/Documentation~/images";

        private const int UsageExitCode = 2;

        /// <summary>Runs those that the command line of the process asks for; a wrong flag ends the program with exit code 2.</summary>
        /// <param name="experiments">The experiments.</param>
        /// <param name="nameOf">Name of one.</param>
        /// <param name="prefix">What the names of the pictures begin with.</param>
        /// <param name="folder">Folder of the pictures without --out; null: none are written.</param>
        /// <param name="run">Runs one, writes its figures to the console and draws it.</param>
        public static void Write<T>(IReadOnlyList<T> experiments, Func<T, string> nameOf, string prefix, string folder,
            Func<T, ParticlePicture> run)
        {
            string PictureOf(string name) => $"{prefix}-{name}.png";
            List<T> chosen;
            try
            {
                FigureArguments arguments = FigureArguments.Parse(Environment.GetCommandLineArgs(), experiments.Select(nameOf).ToArray());
                chosen = experiments.Where(e => arguments.Only == null || nameOf(e) == arguments.Only).ToList();
                folder = arguments.OutputFolder ?? folder;
                // The package's own pictures are replaced; they are under version control.
                if (arguments.OutputFolder != null && Path.GetFullPath(folder) != Path.GetFullPath(PackageImages))
                {
                    ResultFolder.Open(folder, chosen.Select(e => ResultFile.Picture(PictureOf(nameOf(e)))));
                }
            }
            catch (CommandLineException exception)
            {
                Console.Error.WriteLine("figures: " + exception.Message);
                EditorApplication.Exit(UsageExitCode);
                return;
            }
            if (folder != null) Directory.CreateDirectory(folder);
            Console.WriteLine(SystemInfo.graphicsDeviceName);
            foreach (T experiment in chosen)
            {
                ParticlePicture picture = run(experiment);
                if (folder != null) File.WriteAllBytes(Path.Combine(folder, PictureOf(nameOf(experiment))), picture.ToPng());
            }
        }
    }
}
