using System;
using System.Collections.Generic;
using System.ComponentModel;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;

namespace SphFluid.Validation
{
    /// <summary>Draws scripts with the program gnuplot (http://www.gnuplot.info), version 5.2 or later.</summary>
    public static class Gnuplot
    {
        /// <summary>The program's name; it is looked for in the PATH.</summary>
        public const string Program = "gnuplot";

        private const int LongestMilliseconds = 120000;

        /// <summary>Draws a script in its folder.</summary>
        /// <param name="script">The script.</param>
        /// <param name="program">The program.</param>
        /// <returns>Null, or a line that says what is wrong and how to draw it later.</returns>
        public static string Draw(string script, string program = Program)
        {
            string folder = Path.GetDirectoryName(Path.GetFullPath(script));
            var start = new ProcessStartInfo(program, "\"" + Path.GetFileName(script) + "\"")
            {
                WorkingDirectory = folder,
                UseShellExecute = false,
                CreateNoWindow = true,
                RedirectStandardError = true,
            };
            try
            {
                using (Process process = Process.Start(start))
                {
                    string said = process.StandardError.ReadToEnd();
                    if (!process.WaitForExit(LongestMilliseconds))
                    {
                        process.Kill();
                        return $"{program} did not finish '{script}' within {LongestMilliseconds / 1000} s.";
                    }
                    return process.ExitCode == 0 ? null : $"{program} could not draw '{script}': {LastLine(said)}";
                }
            }
            catch (Exception exception) when (exception is Win32Exception || exception is PlatformNotSupportedException ||
                exception is NotSupportedException)
            {
                return $"No picture: the program {program} is not installed (Debian: apt-get install gnuplot-nox, else " +
                    "http://www.gnuplot.info). " +
                    $"Then: cd '{folder}' && {Program} {Path.GetFileName(script)}";
            }
        }

        /// <summary>A text in a script: <c>it's</c> is written <c>'it''s'</c>.</summary>
        public static string Quote(string text) => "'" + text.Replace("'", "''").Replace('\n', ' ') + "'";

        /// <summary>A number in a script; what is not finite is the missing datum NaN.</summary>
        public static string Number(double value) =>
            double.IsNaN(value) || double.IsInfinity(value) ? "NaN" : value.ToString("G6", CultureInfo.InvariantCulture);

        /// <summary>A text in lines of at most some characters, divided between words.</summary>
        public static string[] Wrap(string text, int width)
        {
            var lines = new List<string>();
            var line = new StringBuilder();
            foreach (string word in text.Split(new[] { ' ' }, StringSplitOptions.RemoveEmptyEntries))
            {
                if (line.Length > 0 && line.Length + 1 + word.Length > width)
                {
                    lines.Add(line.ToString());
                    line.Clear();
                }
                line.Append(line.Length > 0 ? " " : "").Append(word);
            }
            if (line.Length > 0) lines.Add(line.ToString());
            return lines.ToArray();
        }

        private static string LastLine(string text) => text.Split('\n').Select(l => l.Trim()).LastOrDefault(l => l.Length > 0) ??
            "it gave no reason.";
    }
}
