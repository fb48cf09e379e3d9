using System.ComponentModel;
using System.Diagnostics;
using System.Text.RegularExpressions;

namespace Headless.Checks.Dxc;

/// <summary>Microsoft's dxcompiler.dll under Wine, driven by the small program dxc_jobs.c. One process at a time uses it.</summary>
/// <param name="cacheFolder">Where setup.sh puts the library; the driver and Wine's files go below it.</param>
internal sealed partial class DxcToolchain(string cacheFolder)
{
    private const string CrossCompiler = "x86_64-w64-mingw32-gcc", LibraryName = "dxcompiler.dll";

    // dxc_jobs ends with 101 to 103 where it cannot start.
    private const int FirstOwnError = 101, LastOwnError = 103;

    private static readonly string[] winePaths = ["/usr/lib/wine/wine64", "/usr/bin/wine64", "/usr/local/bin/wine64"];

    private string WorkFolder => Path.Combine(cacheFolder, "dxc");
    private string Driver => Path.Combine(WorkFolder, "dxc_jobs.exe");
    private static string? Wine => Array.Find(winePaths, File.Exists);

    /// <summary>Builds the driver. Returns null when all is there, else what is missing and how to get it.</summary>
    public string? Prepare()
    {
        var fetched = Path.Combine(cacheFolder, LibraryName);
        if (!File.Exists(fetched)) return $"{LibraryName} is not in {cacheFolder}: run './setup.sh test' with a network";
        if (Wine is null) return "wine64 is not installed: apt-get install wine64";
        Directory.CreateDirectory(WorkFolder);
        using var held = Lock();
        var library = Path.Combine(WorkFolder, LibraryName);
        if (!File.Exists(library) || File.GetLastWriteTimeUtc(library) != File.GetLastWriteTimeUtc(fetched)) File.Copy(fetched, library, overwrite: true);
        var source = Path.Combine(AppContext.BaseDirectory, "Dxc", "dxc_jobs.c");
        if (File.Exists(Driver) && File.GetLastWriteTimeUtc(Driver) >= File.GetLastWriteTimeUtc(source)) return null;
        try
        {
            var (code, output) = RunProcess(new ProcessStartInfo(CrossCompiler, ["-O1", "-Wall", source, "-o", Driver]));
            return code == 0 ? null : $"{CrossCompiler} failed on dxc_jobs.c: {output}";
        }
        catch (Win32Exception) { return $"{CrossCompiler} is not installed: apt-get install gcc-mingw-w64-x86-64"; }
    }

    /// <summary>Compiles the jobs, a line each, and returns a line for each. Where the compiler crashes, another process goes on from there;
    /// a job that crashes that one at once has failed.</summary>
    public List<string> Run(string folder, IReadOnlyList<string> jobs)
    {
        using var held = Lock();
        var results = new List<string>();
        while (results.Count < jobs.Count)
        {
            const string jobFile = "jobs.txt";
            File.WriteAllLines(Path.Combine(folder, jobFile), jobs.Skip(results.Count));
            var info = new ProcessStartInfo(Wine!, [Driver, jobFile]) { WorkingDirectory = folder };
            info.Environment["WINEPREFIX"] = Path.Combine(WorkFolder, "prefix");
            info.Environment["WINEDEBUG"] = "-all";
            info.Environment["WINEDLLOVERRIDES"] = "mscoree=;mshtml=";
            var (code, output) = RunProcess(info);
            if (code is >= FirstOwnError and <= LastOwnError) throw new InvalidOperationException($"dxc_jobs could not start (exit code {code}): {output}");
            var compiled = output.Split('\n').Where(line => ResultLine().IsMatch(line)).ToList();
            results.AddRange(compiled);
            if (compiled.Count == 0) results.Add(jobs[results.Count].Split('\t')[0] + "\tfailed\t0\tdxcompiler.dll crashed");
        }
        return results;
    }

    // Two programs that start Wine in one folder at once can end each other.
    private FileStream Lock()
    {
        for (;;)
        {
            try { return new FileStream(Path.Combine(WorkFolder, "lock"), FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None); }
            catch (IOException) { Thread.Sleep(100); }
        }
    }

    private static (int Code, string Output) RunProcess(ProcessStartInfo info)
    {
        (info.RedirectStandardOutput, info.RedirectStandardError) = (true, true);
        using var process = Process.Start(info)!;
        var errors = process.StandardError.ReadToEndAsync();
        var output = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        return (process.ExitCode, process.ExitCode is >= 0 and <= 100 ? output : output + errors.Result);
    }

    [GeneratedRegex(@"^\d+\t(ok|failed)\t")]
    private static partial Regex ResultLine();
}
