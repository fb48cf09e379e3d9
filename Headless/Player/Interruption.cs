using System.Runtime.InteropServices;
using Headless.Files;
using UnityEngine;

namespace Headless.Player;

/// <summary>
/// Ctrl-C and termination. Loops that look at <see cref="Requested"/> end by themselves; what they are in the middle of, a
/// long frame, an import, a shader, gets a moment, and then the files are ended on another thread and the process with them.
/// A second signal ends it at once.
/// </summary>
internal sealed class Interruption : IDisposable
{
    /// <summary>Exit code of a program that SIGINT ended, as shells have it.</summary>
    public const int ExitCode = 130;

    private static readonly TimeSpan Grace = TimeSpan.FromSeconds(0.7);

    /// <summary>For what follows the last frame: readbacks, results of the project's code.</summary>
    private static readonly TimeSpan Ending = TimeSpan.FromSeconds(10);

    private readonly PosixSignalRegistration[] registrations;
    private readonly Lock gate = new();
    private Timer? deadline;
    private volatile bool requested;
    private int ended;

    public Interruption() =>
        registrations = [PosixSignalRegistration.Create(PosixSignal.SIGINT, Handle), PosixSignalRegistration.Create(PosixSignal.SIGTERM, Handle)];

    public bool Requested => requested;

    /// <summary>Says at once that the signal was heard; called on another thread.</summary>
    public Action? Heard { get; set; }

    /// <summary>Ends the files when the main thread does not come back; called at most once, on another thread.</summary>
    public Action? EndFiles { get; set; }

    /// <summary>Called by the main thread when it has seen the request and ends the files itself.</summary>
    public void Acknowledge()
    {
        lock (gate) deadline?.Change(Ending, Timeout.InfiniteTimeSpan);
    }

    /// <summary>For whoever ends the files: false for the second.</summary>
    public bool MayEndFiles() => Interlocked.Exchange(ref ended, 1) == 0;

    /// <summary>For the main thread, before it ends the files: does not return when the other thread does that already.</summary>
    public void EndHere()
    {
        if (!MayEndFiles()) Thread.Sleep(Timeout.Infinite);
    }

    public void Dispose()
    {
        foreach (PosixSignalRegistration registration in registrations) registration.Dispose();
        lock (gate) deadline?.Dispose();
    }

    private void Handle(PosixSignalContext context)
    {
        context.Cancel = true;
        lock (gate)
        {
            if (!requested)
            {
                requested = true;
                deadline = new Timer(_ => Abandon(), null, Grace, Timeout.InfiniteTimeSpan);
                ThreadPool.QueueUserWorkItem(_ => Heard?.Invoke());
                // Scripts and the package's long starts look at it.
                ThreadPool.QueueUserWorkItem(_ => Application.RequestExit());
                return;
            }
        }
        End();
    }

    private void Abandon()
    {
        if (MayEndFiles())
        {
            try
            {
                EndFiles?.Invoke();
            }
            catch (Exception e)
            {
                Console.Error.WriteLine(Message.Of(OneLine.Message(e.Message)));
            }
        }
        End();
    }

    // Without finalizers and handlers at exit: they would wait for the thread that does not come back.
    private static void End()
    {
        ChildProcesses.KillAll();
        Console.Out.Flush();
        Console.Error.Flush();
        if (OperatingSystem.IsWindows()) Environment.Exit(ExitCode);
        ExitNow(ExitCode);
    }

    [DllImport("libc", EntryPoint = "_exit")]
    private static extern void ExitNow(int code);
}
