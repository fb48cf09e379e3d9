using System;
using System.Collections;
using System.Collections.Generic;
using System.ComponentModel;
using System.Diagnostics;
using System.IO;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// The program PySPH (https://pysph.readthedocs.io): WCSPH and others in Python, with code that it generates and compiles.
    /// </summary>
    internal sealed class PySph
    {
        /// <summary>Debian's Python, for which its archive has PySPH.</summary>
        public const string DefaultPython = "/usr/bin/python3";

        private const string Script = "Packages/com.sphfluid.validation/Peers~/pysph_case.py";
        private const string Cure = "Install PySPH (Debian: apt-get install python3-pysph), or name a Python that has it with --python.";
        private const int WaitMilliseconds = 100, LastLines = 12;

        private readonly string python, script;

        private PySph(string python, string script)
        {
            this.python = python;
            this.script = script;
        }

        /// <summary>Threads that it computes with.</summary>
        public static int Threads => SystemInfo.processorCount;

        /// <summary>Looks whether it is there.</summary>
        /// <param name="python">The Python that has it.</param>
        /// <exception cref="CommandLineException">There is no such Python, or it has no PySPH; the message says what to
        /// install.</exception>
        public static PySph Find(string python)
        {
            var found = new PySph(python, FindScript());
            var said = new List<string>();
            try
            {
                using (Process process = found.Start("--version", said))
                {
                    process.WaitForExit();
                    if (process.ExitCode == 0) return found;
                }
            }
            catch (Exception exception) when (exception is Win32Exception || exception is PlatformNotSupportedException ||
                exception is NotSupportedException)
            {
                throw new CommandLineException($"--python: '{CommandLineWords.Shown(python)}' cannot be started. {Cure}");
            }
            throw new CommandLineException(
                $"--python: {said.LastOrDefault() ?? $"'{CommandLineWords.Shown(python)}' gives no version of PySPH."} {Cure}");
        }

        /// <summary>Runs the case that a folder holds; yields while it runs, and ends it where it is left early.</summary>
        /// <param name="folder">The folder.</param>
        /// <exception cref="IOException">It failed; the message has its last lines.</exception>
        public IEnumerator Run(string folder)
        {
            var said = new List<string>();
            using (Process process = Start($"\"{folder}\"", said))
            {
                try
                {
                    while (!process.WaitForExit(WaitMilliseconds)) yield return null;
                }
                finally
                {
                    if (!process.HasExited) process.Kill();
                }
                process.WaitForExit();
                if (process.ExitCode != 0)
                {
                    throw new IOException(
                        $"PySPH failed with exit code {process.ExitCode}:\n{string.Join("\n", said.Skip(said.Count - LastLines))}");
                }
            }
        }

        // Both streams are read as they come: a full pipe would hold the program back.
        private Process Start(string argument, List<string> said)
        {
            var start = new ProcessStartInfo(python, $"\"{script}\" {argument}")
            {
                UseShellExecute = false,
                CreateNoWindow = true,
                RedirectStandardOutput = true,
                RedirectStandardError = true,
            };
            start.EnvironmentVariables["OMP_NUM_THREADS"] = CsvText.Text(Threads);
            start.EnvironmentVariables["PYTHONDONTWRITEBYTECODE"] = "1";
            Process process = Process.Start(start);
            process.OutputDataReceived += (_, line) => { };
            process.ErrorDataReceived += (_, line) =>
            {
                if (!string.IsNullOrWhiteSpace(line.Data)) said.Add(line.Data);
            };
            process.BeginOutputReadLine();
            process.BeginErrorReadLine();
            return process;
        }

        private static string FindScript()
        {
            string inProject = Path.Combine(Path.GetDirectoryName(Application.dataPath) ?? "", Script);
            string found = new[] { inProject, Path.GetFullPath(Script) }.FirstOrDefault(File.Exists);
            return found ??
                throw new CommandLineException(
                    $"'{Script}' is not there: peers run in the Unity Editor or by ./run, not in a built player.");
        }
    }
}
