using System.ComponentModel;
using System.Diagnostics;

namespace Headless.Shaders;

/// <summary>What a program says to --version.</summary>
internal static class ProgramVersion
{
    /// <summary>The first line, or null when the program is not there.</summary>
    public static string? Read(string program)
    {
        try
        {
            using Process process = Process.Start(new ProcessStartInfo(program, "--version") { RedirectStandardOutput = true })!;
            string text = process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            return text.Split('\n')[0].Trim();
        }
        catch (Win32Exception)
        {
            return null;
        }
    }
}
