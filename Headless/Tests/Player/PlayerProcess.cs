using System.Diagnostics;

namespace Headless.Tests.Player;

/// <summary>Runs the player as a user does: a process of its own.</summary>
internal sealed class PlayerProcess
{
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

    public static Process Start(params string[] words)
    {
        string program = Path.Combine(AppContext.BaseDirectory, "sphplayer.dll");
        return Process.Start(new ProcessStartInfo("dotnet", [program, .. words]) { RedirectStandardOutput = true, RedirectStandardError = true })!;
    }

    public static PlayerProcess Finish(Process process)
    {
        Task<string> errors = process.StandardError.ReadToEndAsync();
        string output = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        return new PlayerProcess(process.ExitCode, output, errors.Result);
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
