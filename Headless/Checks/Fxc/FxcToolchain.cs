using System.Diagnostics;
using System.Text.RegularExpressions;

namespace Headless.Checks.Fxc;

/// <summary>Microsoft's d3dcompiler_47.dll under Wine, driven by the small program fxc_jobs.c.</summary>
internal sealed partial class FxcToolchain(string cacheFolder)
{
    private const string CrossCompiler = "x86_64-w64-mingw32-gcc";

    // fxc_jobs ends with 101 to 103 where it cannot start. A crash ends it with any code: Wine passes on the lowest byte of Windows's.
    private const int FirstStartError = 101, LastStartError = 103;

    private static readonly string[] winePaths = ["/usr/lib/wine/wine64", "/usr/bin/wine64", "/usr/local/bin/wine64"];

    private string Fetched => Path.Combine(cacheFolder, "d3dcompiler_47.dll");
    private string WorkFolder => Path.Combine(cacheFolder, "fxc");
    private string Library => Path.Combine(WorkFolder, "d3dcompiler_47.dll");
    private string Driver => Path.Combine(WorkFolder, "fxc_jobs.exe");

    /// <summary>Builds the driver where needed. Returns null when all is there, else what is missing and how to get it.</summary>
    public string? Prepare()
    {
        if (!File.Exists(Fetched))
            return $"d3dcompiler_47.dll is not in {cacheFolder}: run './setup.sh test' with a network";
        if (Wine is null) return "wine64 is not installed: apt-get install wine64";
        Directory.CreateDirectory(WorkFolder);
        File.Copy(Fetched, Library, overwrite: true);
        var source = Path.Combine(AppContext.BaseDirectory, "Fxc", "fxc_jobs.c");
        if (File.Exists(Driver) && File.GetLastWriteTimeUtc(Driver) >= File.GetLastWriteTimeUtc(source)) return null;
        try
        {
            var (code, output) = RunProcess(CrossCompiler, ["-O1", "-Wall", source, "-o", Driver], null);
            return code == 0 ? null : $"{CrossCompiler} failed on fxc_jobs.c: {output}";
        }
        catch (System.ComponentModel.Win32Exception)
        {
            return $"{CrossCompiler} is not installed: apt-get install gcc-mingw-w64-x86-64";
        }
    }

    [GeneratedRegex(@"^\d+\t(ok|failed)\t")]
    private static partial Regex ResultLine();

    private static string? Wine => Array.Find(winePaths, File.Exists);

    /// <summary>Compiles the jobs, a line each, and returns a line for each; what Wine says of itself is left out. One process does
    /// them all. Where the compiler crashes, another process goes on from there; a job that crashes that one at once has failed.</summary>
    public List<string> Run(string folder, IReadOnlyList<string> jobs)
    {
        var results = new List<string>();
        while (results.Count < jobs.Count)
        {
            var (code, output) = RunJobs(folder, jobs.Skip(results.Count));
            if (code is >= FirstStartError and <= LastStartError) throw new InvalidOperationException($"fxc_jobs could not start (exit code {code}): {output}");
            var compiled = output.Split('\n').Where(line => ResultLine().IsMatch(line)).ToList();
            results.AddRange(compiled);
            if (compiled.Count == 0) results.Add(jobs[results.Count].Split('\t')[0] + "\tfailed\t0\t0\t0\t0\td3dcompiler_47.dll crashed");
        }
        return results;
    }

    private (int Code, string Output) RunJobs(string folder, IEnumerable<string> jobs)
    {
        const string jobFile = "jobs.txt";
        File.WriteAllLines(Path.Combine(folder, jobFile), jobs);
        var environment = new Dictionary<string, string>
        {
            ["WINEPREFIX"] = Path.Combine(WorkFolder, "prefix"),
            ["WINEDEBUG"] = "-all",
            ["WINEDLLOVERRIDES"] = "d3dcompiler_47=n;mscoree=;mshtml=",
        };
        return RunProcess(Wine!, [Driver, jobFile], environment, folder);
    }

    private static (int, string) RunProcess(string file, IEnumerable<string> arguments, Dictionary<string, string>? environment, string? folder = null)
    {
        var info = new ProcessStartInfo(file, arguments) { RedirectStandardOutput = true, RedirectStandardError = true, WorkingDirectory = folder ?? "" };
        foreach (var (key, value) in environment ?? []) info.Environment[key] = value;
        using var process = Process.Start(info)!;
        var errors = process.StandardError.ReadToEndAsync();
        var output = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        return (process.ExitCode, process.ExitCode is >= 0 and <= 100 ? output : output + errors.Result);
    }
}
