using System.ComponentModel;
using System.Diagnostics;
using System.Security.Cryptography;
using System.Text;
using System.Text.RegularExpressions;

namespace Headless.Shaders.Direct3D;

/// <summary>One of Microsoft's shader compilers under Wine, driven by a small program. Several processes may use it at once.</summary>
/// <param name="cacheFolder">Where setup.sh puts the library; the driver and Wine's files go below it.</param>
internal sealed partial class WineToolchain(WineDriver driver, string cacheFolder)
{
    private const string CrossCompiler = "x86_64-w64-mingw32-gcc";
    private const string SharedSource = "jobs.h";
    private const string CodeSuffix = ".code";

    // A driver ends with 101 to 104 where it cannot work. A crash ends it with any code: Wine passes on the lowest byte of Windows's.
    private const int FirstOwnError = 101, LastOwnError = 104;

    private static readonly string[] winePaths = ["/usr/lib/wine/wine64", "/usr/bin/wine64", "/usr/local/bin/wine64"];

    // Of the library and of the driver.
    private readonly Lazy<string> _tools = new(() => Convert.ToHexString(SHA256.HashData(
        [.. File.ReadAllBytes(Path.Combine(cacheFolder, driver.Library)), .. Source(driver.Name + ".c"), .. Source(SharedSource)])));

    private string Fetched => Path.Combine(cacheFolder, driver.Library);
    private string WorkFolder => Path.Combine(cacheFolder, driver.Folder);
    private string SourceName => driver.Name + ".c";
    private string Program => Path.Combine(WorkFolder, driver.Name + ".exe");
    private string Prefix => Path.Combine(WorkFolder, "prefix");

    private string? Missing() =>
        !File.Exists(Fetched) ? $"{driver.Library} is not in {cacheFolder}: run './setup.sh test' with a network"
        : Wine is null ? "wine64 is not installed: apt-get install wine64"
        : null;

    /// <summary>Content hash of the library.</summary>
    public string Version() => Convert.ToHexStringLower(SHA256.HashData(File.ReadAllBytes(Fetched)))[..16];

    /// <summary>Builds the driver where needed. Returns null when all is there, else what is missing and how to get it.</summary>
    public string? Prepare()
    {
        if (Missing() is { } missing)
        {
            return missing;
        }
        Directory.CreateDirectory(WorkFolder);
        using FileStream held = Lock(Path.Combine(WorkFolder, "lock"));
        // Another process may have these files open: they are put in place whole, and only where they differ.
        Replace(Path.Combine(WorkFolder, driver.Library), File.ReadAllBytes(Fetched));
        bool changed = Replace(Path.Combine(WorkFolder, SourceName), Source(SourceName))
            | Replace(Path.Combine(WorkFolder, SharedSource), Source(SharedSource));
        return (changed || !File.Exists(Program) ? BuildDriver() : null) ?? CreatePrefix();
    }

    private string? BuildDriver()
    {
        string built = Program + ".new";
        File.Delete(Program);
        try
        {
            (int code, string output) = RunProcess(new ProcessStartInfo(
                CrossCompiler, ["-O1", "-Wall", Path.Combine(WorkFolder, SourceName), "-o", built]));
            if (code != 0)
            {
                return $"{CrossCompiler} failed on {SourceName}: {output}";
            }
        }
        catch (Win32Exception)
        {
            return $"{CrossCompiler} is not installed: apt-get install gcc-mingw-w64-x86-64";
        }
        File.Move(built, Program);
        return null;
    }

    /// <summary>Compiles the jobs, a line each, and returns a line for each; what Wine says of itself is left out. What was compiled
    /// before without a message is known by its text: its figures, CPU time among them, are those of that time.</summary>
    public List<string> Run(string folder, IReadOnlyList<string> jobs)
    {
        List<string> results = [], rest = [];
        Dictionary<string, (string Known, string? Code)> files = [];
        foreach (string job in jobs)
        {
            string[] words = job.Split('\t');
            (string known, string? code) = files[words[0]] = (KnownFile(File.ReadAllText(Path.Combine(folder, words[1])), words[2], words[3]), words.ElementAtOrDefault(4));
            if (File.Exists(known) && (code is null || File.Exists(known + CodeSuffix)))
            {
                results.Add($"{words[0]}\t{File.ReadAllText(known)}");
            }
            else
            {
                rest.Add(job);
            }
        }
        foreach (string line in Compile(folder, rest))
        {
            results.Add(line);
            string[] fields = line.TrimEnd('\r').Split('\t');
            if (fields[1] == "ok" && fields.ElementAtOrDefault(2 + driver.NoFigures.Split('\t').Length) is null or "")
            {
                (string known, string? code) = files[fields[0]];
                if (code is not null)
                {
                    Keep(known + CodeSuffix, File.ReadAllBytes(Path.Combine(folder, code)));
                }
                Keep(known, Encoding.UTF8.GetBytes(string.Join('\t', fields[1..])));
            }
        }
        return results;
    }

    /// <summary>The code of a text that <see cref="Run"/> compiled; null where it did not.</summary>
    public byte[]? KnownCode(string text, string entryPoint, string profile) =>
        KnownFile(text, entryPoint, profile) + CodeSuffix is var file && File.Exists(file) ? File.ReadAllBytes(file) : null;

    // By all that decides on a result. Where the text's lines come from shows in messages alone.
    private string KnownFile(string text, string entryPoint, string profile)
    {
        string[] all = [_tools.Value, entryPoint, profile, LineDirective().Replace(text, "")];
        return Path.Combine(WorkFolder, "known", Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(string.Join('\0', all)))));
    }

    private static void Keep(string path, byte[] content)
    {
        string whole = path + "." + Guid.NewGuid().ToString("N");
        Directory.CreateDirectory(Path.GetDirectoryName(path)!);
        File.WriteAllBytes(whole, content);
        File.Move(whole, path, overwrite: true);
    }

    // One process does them all. Where the compiler crashes, another process goes on from there; a job that crashes that one at once has failed.
    private List<string> Compile(string folder, IReadOnlyList<string> jobs)
    {
        List<string> results = [];
        while (results.Count < jobs.Count)
        {
            const string jobFile = "jobs.txt";
            File.WriteAllLines(Path.Combine(folder, jobFile), jobs.Skip(results.Count));
            (int code, string output) = RunProcess(Start(folder, jobFile));
            if (code is >= FirstOwnError and <= LastOwnError)
            {
                throw new InvalidOperationException($"{driver.Name} could not start (exit code {code}): {output}");
            }
            List<string> compiled = [.. output.Split('\n').Where(IsResult)];
            results.AddRange(compiled);
            if (compiled.Count == 0)
            {
                results.Add(Crashed(jobs[results.Count].Split('\t')[0]));
            }
        }
        return results;
    }

    /// <summary>How to start the driver on a file of jobs, or on "-" for jobs from standard input.</summary>
    public ProcessStartInfo Start(string folder, string jobFile)
    {
        ProcessStartInfo start = new(Wine!, [Program, jobFile]) { WorkingDirectory = folder };
        start.Environment["WINEPREFIX"] = Prefix;
        start.Environment["WINEDEBUG"] = "-all";
        start.Environment["WINEDLLOVERRIDES"] = driver.Overrides;
        return start;
    }

    /// <summary>Whether a line of output is the driver's and not Wine's.</summary>
    public static bool IsResult(string line) => ResultLine().IsMatch(line);

    /// <summary>The result of a job on which the compiler crashed.</summary>
    public string Crashed(string job) => $"{job}\tfailed\t{driver.NoFigures}\t{driver.Library} crashed";

    private static string? Wine => Array.Find(winePaths, File.Exists);

    // Two processes that make it at the same time would crash.
    private string? CreatePrefix()
    {
        string mark = Path.Combine(Prefix, "made");
        if (File.Exists(mark))
        {
            return null;
        }
        Directory.CreateDirectory(Prefix);
        const string noJobs = "none.txt";
        File.WriteAllText(Path.Combine(WorkFolder, noJobs), "");
        (int code, string output) = RunProcess(Start(WorkFolder, noJobs));
        if (code != 0)
        {
            return $"{driver.Name}.exe does not start under Wine (exit code {code}): {output.Trim()}";
        }
        File.WriteAllText(mark, "");
        return null;
    }

    private static FileStream Lock(string path)
    {
        while (true)
        {
            try
            {
                return new FileStream(path, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None);
            }
            catch (IOException)
            {
                Thread.Sleep(100);
            }
        }
    }

    // True when the file was another one.
    private static bool Replace(string path, byte[] content)
    {
        if (File.Exists(path) && File.ReadAllBytes(path).AsSpan().SequenceEqual(content))
        {
            return false;
        }
        File.WriteAllBytes(path + ".new", content);
        File.Move(path + ".new", path, overwrite: true);
        return true;
    }

    private static byte[] Source(string name)
    {
        using Stream stream = typeof(WineToolchain).Assembly.GetManifestResourceStream(name)!;
        using MemoryStream copy = new();
        stream.CopyTo(copy);
        return copy.ToArray();
    }

    private static (int Code, string Output) RunProcess(ProcessStartInfo start)
    {
        start.RedirectStandardOutput = true;
        start.RedirectStandardError = true;
        using Process process = Process.Start(start)!;
        Task<string> errors = process.StandardError.ReadToEndAsync();
        string output = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        return (process.ExitCode, process.ExitCode is >= 0 and <= 100 ? output : output + errors.Result);
    }

    [GeneratedRegex(@"^#line .*$", RegexOptions.Multiline)]
    private static partial Regex LineDirective();

    [GeneratedRegex(@"^\d+\t(ok|failed)\t")]
    private static partial Regex ResultLine();
}
