using System.Diagnostics;
using NUnit.Framework;

namespace Headless.Tests.Player;

/// <summary>Runs the player as a user does: a process of its own.</summary>
internal sealed class PlayerProcess
{
    private const int Interrupt = 2;

    // GNU coreutils 8.31 and later.
    private const string DefaultSignal = "--default-signal=INT";

    private static readonly TimeSpan Longest = TimeSpan.FromMinutes(10);

    private static readonly Lazy<bool> TakesDefaultSignal = new(() =>
    {
        if (OperatingSystem.IsWindows()) return false;
        using Process trial = Process.Start(new ProcessStartInfo("env", [DefaultSignal, "true"]) { RedirectStandardError = true })!;
        trial.WaitForExit();
        return trial.ExitCode == 0;
    });

    private PlayerProcess(int exitCode, string output, string errors) => (ExitCode, Output, Errors) = (exitCode, output, errors);

    public int ExitCode { get; }
    public string Output { get; }
    public string Errors { get; }

    public static string ProjectsFolder { get; } = FindUp("Headless/Tests/Projects");

    public static PlayerProcess Run(params string[] words)
    {
        using Process process = Start(words);
        return Finish(process);
    }

    /// <summary>Runs it with a folder for its temporary files.</summary>
    public static PlayerProcess RunIn(string folder, params string[] words) => RunWith([("TMPDIR", folder)], words);

    /// <summary>Runs it with variables of the environment.</summary>
    public static PlayerProcess RunWith((string Name, string Value)[] variables, params string[] words)
    {
        using Process process = Start(words, variables);
        return Finish(process);
    }

    /// <summary>Starts it so that it takes SIGINT, which a shell's background job (command &amp;) hands down as ignored.</summary>
    public static Process Start(params string[] words) => Start(words, []);

    private static Process Start(string[] words, (string Name, string Value)[] variables)
    {
        string program = Path.Combine(AppContext.BaseDirectory, "sphplayer.dll");
        string[] command = ["dotnet", program, .. words];
        if (TakesDefaultSignal.Value) command = ["env", DefaultSignal, .. command];
        var start = new ProcessStartInfo(command[0], command[1..]) { RedirectStandardOutput = true, RedirectStandardError = true };
        foreach ((string name, string value) in variables) start.Environment[name] = value;
        return Process.Start(start)!;
    }

    /// <summary>Waits for its end; the test fails, and the process is ended, where that does not come in time.</summary>
    public static PlayerProcess Finish(Process process, TimeSpan? limit = null)
    {
        Task<string> errors = process.StandardError.ReadToEndAsync();
        Task<string> output = process.StandardOutput.ReadToEndAsync();
        TimeSpan most = limit ?? Longest;
        if (!process.WaitForExit(most))
        {
            string why = IgnoresInterrupt(process) ? " It ignores SIGINT, as background jobs of a shell do: run the tests in the foreground." : "";
            process.Kill(entireProcessTree: true);
            Assert.Fail($"The player did not end within {most.TotalSeconds:0} s.{why}");
        }
        process.WaitForExit();
        return new PlayerProcess(process.ExitCode, output.Result, errors.Result);
    }

    /// <summary>Whether SIGINT does nothing, by the kernel's list of ignored signals.</summary>
    public static bool IgnoresInterrupt(Process process)
    {
        string status = $"/proc/{process.Id}/status";
        string? ignored = File.Exists(status) ? File.ReadLines(status).FirstOrDefault(l => l.StartsWith("SigIgn:", StringComparison.Ordinal)) : null;
        return ignored is not null && (Convert.ToUInt64(ignored["SigIgn:".Length..].Trim(), 16) & (1UL << (Interrupt - 1))) != 0;
    }

    /// <summary>Where a project of Tests/Projects was built: beside this assembly's own output folder.</summary>
    public static string AssembliesOf(string project)
    {
        var own = new DirectoryInfo(Path.TrimEndingDirectorySeparator(AppContext.BaseDirectory));
        string folder = Path.Combine(own.Parent!.Parent!.FullName, project, own.Name);
        return Directory.Exists(folder) ? folder : throw new DirectoryNotFoundException($"'{folder}' is missing: build Headless/Tests/Projects/{project}.csproj.");
    }

    private static string FindUp(string relative)
    {
        for (DirectoryInfo? folder = new(AppContext.BaseDirectory); folder is not null; folder = folder.Parent)
            if (Directory.Exists(Path.Combine(folder.FullName, relative))) return Path.Combine(folder.FullName, relative);
        return Environment.GetEnvironmentVariable("HEADLESS_TEST_PROJECTS") ?? throw new DirectoryNotFoundException($"{relative} is not above {AppContext.BaseDirectory}; set HEADLESS_TEST_PROJECTS.");
    }
}
