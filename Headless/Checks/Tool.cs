using System.ComponentModel;
using System.Diagnostics;

namespace Headless.Checks;

/// <summary>A program of the machine that reads and writes files.</summary>
internal static class Tool
{
    /// <summary>Exit code, and all that the program printed; null where the machine does not have it.</summary>
    public static (int Code, string Output)? Run(string program, params string[] words)
    {
        try
        {
            using var process = Process.Start(new ProcessStartInfo(program, words) { RedirectStandardOutput = true, RedirectStandardError = true })!;
            var errors = process.StandardError.ReadToEndAsync();
            var output = process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            return (process.ExitCode, (output + errors.Result).Trim());
        }
        catch (Win32Exception) { return null; }
    }
}
