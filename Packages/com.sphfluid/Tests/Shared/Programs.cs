using System.ComponentModel;
using System.Diagnostics;
using System.Text;
using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>Programs of the system that tests ask.</summary>
    internal static class Programs
    {
        /// <summary>Runs a program that must succeed; where it is not installed the test is ignored.</summary>
        /// <param name="program">Its name.</param>
        /// <param name="words">What it is given.</param>
        /// <returns>What it printed.</returns>
        public static string Run(string program, params string[] words)
        {
            var start =
                new ProcessStartInfo(program) { UseShellExecute = false, RedirectStandardOutput = true, RedirectStandardError = true };
            foreach (string word in words) start.ArgumentList.Add(word);
            try
            {
                using (Process process = Process.Start(start))
                {
                    var errors = new StringBuilder();
                    process.ErrorDataReceived += (_, line) => errors.AppendLine(line.Data);
                    process.BeginErrorReadLine();
                    string said = process.StandardOutput.ReadToEnd();
                    process.WaitForExit();
                    Assert.That(process.ExitCode, Is.Zero, errors.ToString());
                    return said;
                }
            }
            catch (Win32Exception)
            {
                Assert.Ignore($"{program} is not installed.");
                throw;
            }
        }
    }
}
