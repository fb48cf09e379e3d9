using System.Diagnostics;
using System.Text.RegularExpressions;
using Headless.Files;

namespace Headless.Shaders;

/// <summary>Runs glslangValidator, which can crash, as a child process.</summary>
internal sealed partial class GlslangProcess(string program)
{
    private static readonly TimeSpan Limit = TimeSpan.FromMinutes(5);

    // Macros that grow without end take all memory of a machine, and time. The largest kernel needs a second and 200 MB.
    private const string Prlimit = "/usr/bin/prlimit";
    private const long MostBytes = 4L << 30;
    private const int MostSeconds = 60;

    // glslang prints it and ends well, with SPIR-V that is not valid.
    private const string MissingMark = "Missing functionality:";

    private readonly Lazy<string?> _version = new(() => ProgramVersion.Read(program));

    /// <summary>Version text, or null when the program is not there.</summary>
    public string? Version => _version.Value;

    /// <summary>SPIR-V as glslang leaves it.</summary>
    /// <param name="lines">Whether it names the line that each instruction comes from.</param>
    public byte[] Compile(StageJob job, bool lines = false)
    {
        string output = Path.Combine(Path.GetTempPath(), $"headless-shader-{Guid.NewGuid():N}.spv");
        try
        {
            (int exit, string text) = Run(job with { Text = ConstantRemainders.KeepFromFolding(job.Text) },
            [
                "--stdin", "-V", "--target-env", "vulkan1.1", "-D", "--hlsl-offsets", "-fhlsl_functionality1", "--nan-clamp",
                "--hlsl-dx-position-w", "-S", StageName(job.Stage), "-e", job.SourceEntryPoint, "-o", output, .. lines ? ["-g"] : Array.Empty<string>(),
            ], output);
            if (exit is > 2 or < 0)
            {
                throw new ShaderCompileException(
                    job.Source.Files[0], 0,
                    $"glslangValidator stopped with exit code {exit} on {job.Owner}; a static const in [numthreads] is known to "
                    + $"do this, use #define, and so are macros that need more than {MostSeconds} s or {MostBytes >> 30} GiB");
            }
            if (exit != 0 || !File.Exists(output) || text.Contains("Entry point not found", StringComparison.Ordinal))
            {
                throw Failure(job, text);
            }
            int missing = text.IndexOf(MissingMark, StringComparison.Ordinal);
            if (missing >= 0)
            {
                string what = text[(missing + MissingMark.Length)..].Split('\n')[0].Trim();
                throw new ShaderCompileException(job.Source.Files[0], 0, $"glslangValidator cannot translate a {what} ({job.Owner})");
            }
            return File.ReadAllBytes(output);
        }
        finally
        {
            File.Delete(output);
        }
    }

    /// <summary>The text behind the preprocessor: macros expanded, branches of #if chosen.</summary>
    public string Preprocess(StageJob job)
    {
        (int exit, string text) = Run(job, ["--stdin", "-D", "-E", "-S", StageName(job.Stage)]);
        return exit == 0 ? text : throw Failure(job, text);
    }

    private static string StageName(ShaderStage stage) => stage switch
    {
        ShaderStage.Compute => "comp",
        ShaderStage.Vertex => "vert",
        ShaderStage.Geometry => "geom",
        _ => "frag",
    };

    private (int Exit, string Text) Run(StageJob job, string[] arguments, string? output = null)
    {
        bool bounded = File.Exists(Prlimit);
        ProcessStartInfo start = new(bounded ? Prlimit : program)
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        foreach (string argument in bounded ? [$"--as={MostBytes}", $"--cpu={MostSeconds}", program, .. arguments] : arguments)
        {
            start.ArgumentList.Add(argument);
        }
        using Process process = Process.Start(start)!;
        using IDisposable listed = ChildProcesses.Add(process, output);
        Task<string> standard = process.StandardOutput.ReadToEndAsync();
        Task<string> error = process.StandardError.ReadToEndAsync();
        try
        {
            process.StandardInput.Write(job.Text);
            process.StandardInput.Close();
        }
        catch (IOException)
        {
            // The process ended before it read everything: its exit code tells why.
        }
        if (!process.WaitForExit(Limit))
        {
            process.Kill();
            throw new ShaderCompileException(
                job.Source.Files[0], 0, $"glslangValidator did not finish {job.Owner} in {Limit.TotalMinutes} minutes");
        }
        return (process.ExitCode, standard.Result + "\n" + error.Result);
    }

    private static ShaderCompileException Failure(StageJob job, string output)
    {
        foreach (string line in output.Split('\n'))
        {
            Match error = ErrorLine().Match(line);
            if (error.Success)
            {
                string file = job.Source.FileName(int.Parse(error.Groups[1].Value));
                return new ShaderCompileException(file, int.Parse(error.Groups[2].Value), Message(error.Groups[3].Value, job));
            }
        }
        if (output.Contains("Entry point not found", StringComparison.Ordinal))
        {
            return new ShaderCompileException(job.Source.Files[0], 0, $"no function '{job.EntryPoint}' for {job.Owner}");
        }
        string rest = string.Join("; ", output.Split('\n', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries)
            .Where(l => l != "stdin"));
        return new ShaderCompileException(job.Source.Files[0], 0, $"{rest} ({job.Owner})");
    }

    // "'#error' : HEADLESS_MESSAGE_0  " and "'x' : unknown variable "
    private static string Message(string text, StageJob job)
    {
        int word = text.IndexOf(ExpandedSource.MessageWord, StringComparison.Ordinal);
        string message = word < 0
            ? text.Trim()
            : job.Source.Messages[int.Parse(text[(word + ExpandedSource.MessageWord.Length)..].Trim())];
        return $"{message} at {job.Owner}";
    }

    [GeneratedRegex(@"^ERROR: (\d+):(\d+): (.*)$")]
    private static partial Regex ErrorLine();
}
