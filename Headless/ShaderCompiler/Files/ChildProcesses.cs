using System.Collections.Concurrent;
using System.ComponentModel;
using System.Diagnostics;

namespace Headless.Files;

/// <summary>Programs that work for this process and should not outlive it, with the files they are writing.</summary>
public static class ChildProcesses
{
    private static readonly ConcurrentDictionary<Process, string?> Running = new();

    /// <param name="unfinished">File to be removed when the program is killed.</param>
    /// <returns>Takes the program off the list.</returns>
    public static IDisposable Add(Process process, string? unfinished)
    {
        Running[process] = unfinished;
        return new Entry(process);
    }

    public static void KillAll()
    {
        foreach (var (process, unfinished) in Running)
        {
            try
            {
                process.Kill(entireProcessTree: true);
                if (unfinished is not null) File.Delete(unfinished);
            }
            catch (Exception e) when (e is InvalidOperationException or Win32Exception or IOException or UnauthorizedAccessException)
            {
                // It has ended by itself.
            }
        }
    }

    private sealed class Entry(Process process) : IDisposable
    {
        public void Dispose() => Running.TryRemove(process, out _);
    }
}
