using System.ComponentModel;
using System.Diagnostics;

namespace Headless.Player.Output;

/// <summary>Shows a film with the program that the desktop has for films.</summary>
internal static class FilmViewer
{
    /// <summary>Why nothing can be shown, as a part of a sentence; null where there is a display.</summary>
    /// <param name="variable">An environment variable's value by name.</param>
    public static string? Missing(Func<string, string?> variable)
    {
        if (OperatingSystem.IsWindows() || OperatingSystem.IsMacOS()) return null;
        return string.IsNullOrEmpty(variable("DISPLAY")) && string.IsNullOrEmpty(variable("WAYLAND_DISPLAY"))
            ? "there is no display here (neither DISPLAY nor WAYLAND_DISPLAY is set)" : null;
    }

    /// <summary>Opens the film and does not wait for it.</summary>
    /// <returns>Null when it was opened, else why not.</returns>
    public static string? Open(string film)
    {
        if (Missing(Environment.GetEnvironmentVariable) is { } missing) return missing;
        try
        {
            // Its output would be mixed with the shell's prompt.
            ProcessStartInfo start = OperatingSystem.IsWindows() ? new(film) { UseShellExecute = true }
                : new(OperatingSystem.IsMacOS() ? "open" : "xdg-open", [film]) { RedirectStandardOutput = true, RedirectStandardError = true };
            using Process? viewer = Process.Start(start);
            return null;
        }
        catch (Win32Exception)
        {
            return "xdg-open is not installed (Debian: apt install xdg-utils)";
        }
    }
}
