using System.Diagnostics;
using System.Globalization;
using System.Net.Sockets;
using System.Text;
using Headless.Pacing;

namespace Headless.Bench.Scene;

/// <summary>A build's player at work on the scene: it plays frames as it is asked to.</summary>
internal sealed class PacedPlayer : IDisposable
{
    /// <summary>Property of the package whose growth is the number of dispatches.</summary>
    private const string Dispatches = "SphFluid.ComputeKernel.DispatchesRecorded";

    private const string Method = "SphFluid.Validation.CommandLine.Play";
    private static readonly TimeSpan startLimit = TimeSpan.FromMinutes(5);

    private readonly Dictionary<int, PlayedFrame> frames = [];
    private readonly StringBuilder output = new();
    private readonly DirectoryInfo folder;
    private readonly Process process;
    private readonly NetworkStream stream;
    private readonly StreamReader reader;

    private PacedPlayer(PlayerBuild build, DirectoryInfo folder, Process process, Socket listener)
    {
        (Build, this.folder, this.process) = (build, folder, process);
        process.OutputDataReceived += (_, line) => Keep(line.Data);
        process.ErrorDataReceived += (_, line) => Keep(line.Data);
        process.BeginOutputReadLine();
        process.BeginErrorReadLine();
        Task<Socket> connection = listener.AcceptAsync();
        Task first = Task.WhenAny(connection, process.WaitForExitAsync(), Task.Delay(startLimit)).Result;
        if (first != connection) throw Failure("did not begin to play");
        stream = new NetworkStream(connection.Result, ownsSocket: true);
        reader = new StreamReader(stream);
    }

    public PlayerBuild Build { get; }

    /// <summary>The device that summary.json names.</summary>
    public string DeviceName { get; private set; } = "";

    public string Driver { get; private set; } = "";

    /// <summary>Empty where the player is older than its line in summary.json.</summary>
    public string Processor { get; private set; } = "";
    public long Particles { get; private set; }

    /// <summary>Frames from 0; what a frame did is whole after <see cref="Finish"/>.</summary>
    public IReadOnlyDictionary<int, PlayedFrame> Frames => frames;

    /// <param name="frames">Frames to be played.</param>
    public static PacedPlayer Start(SceneOptions options, PlayerBuild build, int frames)
    {
        DirectoryInfo folder = Directory.CreateTempSubdirectory("sphbench");
        string assemblies = Path.Combine(folder.FullName, "assemblies"), socket = Path.Combine(folder.FullName, "pace");
        Directory.CreateDirectory(assemblies);
        foreach (string file in Directory.EnumerateFiles(build.Assemblies, "*.dll").Append(typeof(Pacer).Assembly.Location))
            File.Copy(file, Path.Combine(assemblies, Path.GetFileName(file)));
        using var listener = new Socket(AddressFamily.Unix, SocketType.Stream, ProtocolType.Unspecified);
        listener.Bind(new UnixDomainSocketEndPoint(socket));
        listener.Listen();
        string seconds = ((frames - 1) / options.Fps).ToString("R", CultureInfo.InvariantCulture);
        string[] device = options.Device is { } name ? ["--device", name] : [];
        string[] pipeline = options.Pipeline is { } asked ? ["--pipeline", asked] : [];
        var start = new ProcessStartInfo(build.Player,
        [
            "play", "--project", build.Folder, "--assemblies", assemblies, "--scene", build.SceneOf(options.Scene, options.Build),
            "--executeMethod", "Headless.Pacing.Pacer.Play", "--seconds", seconds, "--fps", options.Fps.ToString("R", CultureInfo.InvariantCulture),
            "--size", options.Size, "--no-images", "--out", Path.Combine(folder.FullName, "play"), .. device, .. pipeline, "--", .. options.Words,
        ])
        { RedirectStandardOutput = true, RedirectStandardError = true };
        start.Environment[Pacer.SocketVariable] = socket;
        start.Environment[Pacer.MethodVariable] = Method;
        start.Environment[Pacer.CountersVariable] = Dispatches;
        return new PacedPlayer(build, folder, Process.Start(start)!, listener);
    }

    /// <summary>Takes in what comes until the player waits before a frame.</summary>
    public void WaitFor(int frame)
    {
        while (Next() is { } line)
        {
            if (line is ["ready", var at, ..] && Int(at) == frame) return;
        }
        throw Failure($"ended before frame {frame}");
    }

    /// <summary>Plays one frame and measures the processor time that the player's threads took for it.</summary>
    public void Play(int frame, bool last)
    {
        process.Refresh();
        TimeSpan before = process.TotalProcessorTime;
        Go(1, draws: true);
        if (last) return;
        WaitFor(frame + 1);
        process.Refresh();
        Frame(frame).Processor = (process.TotalProcessorTime - before).TotalMilliseconds;
    }

    /// <summary>Lets it play frames.</summary>
    /// <param name="draws">Whether cameras draw them.</param>
    public void Go(int count, bool draws) => stream.Write(Encoding.UTF8.GetBytes($"go {count} {(draws ? "draw" : "blind")}\n"));

    /// <summary>Takes in the rest and what the player wrote at its end.</summary>
    public void Finish()
    {
        while (Next() is not null)
        {
        }
        process.WaitForExit();
        if (process.ExitCode != 0) throw Failure($"ended with exit code {process.ExitCode}");
        string[][] rows = [.. File.ReadLines(Path.Combine(folder.FullName, "play", "timings.csv")).Select(line => line.Split(','))];
        int steps = Array.IndexOf(rows[0], "steps");
        foreach (string[] row in rows.Skip(1).Where(r => r[steps].Length > 0)) Frame(Int(row[0])).Steps = long.Parse(row[steps], CultureInfo.InvariantCulture);
        using var summary = System.Text.Json.JsonDocument.Parse(File.ReadAllBytes(Path.Combine(folder.FullName, "play", "summary.json")));
        DeviceName = summary.RootElement.GetProperty("device").GetString() ?? "";
        Driver = summary.RootElement.GetProperty("driver").GetString() ?? "";
        Processor = summary.RootElement.TryGetProperty("processor", out var processor) ? processor.GetString() ?? "" : "";
        Particles = summary.RootElement.TryGetProperty("particles", out var particles) ? particles.GetInt64() : 0;
    }

    public void Dispose()
    {
        reader.Dispose();
        stream.Dispose();
        if (!process.HasExited) process.Kill(entireProcessTree: true);
        process.Dispose();
        folder.Delete(recursive: true);
    }

    private string[]? Next()
    {
        string[]? words;
        try
        {
            words = reader.ReadLine()?.Split(' ', 5);
        }
        catch (IOException)
        {
            return null;
        }
        if (words is ["gpu", var frame, var milliseconds, var times, var scope])
            Frame(Int(frame)).Scopes[scope] = (double.Parse(milliseconds, CultureInfo.InvariantCulture), Int(times));
        else if (words is ["count", var of, var number, Dispatches])
            Frame(Int(of)).Dispatches = long.Parse(number, CultureInfo.InvariantCulture);
        return words;
    }

    private PlayedFrame Frame(int number)
    {
        if (!frames.TryGetValue(number, out PlayedFrame? frame)) frames.Add(number, frame = new PlayedFrame());
        return frame;
    }

    private void Keep(string? line)
    {
        const int most = 4000;
        if (line is null) return;
        lock (output)
        {
            output.AppendLine(line);
            if (output.Length > most) output.Remove(0, output.Length - most);
        }
    }

    private PlayerFailedException Failure(string what)
    {
        if (!process.WaitForExit(TimeSpan.FromSeconds(5))) process.Kill(entireProcessTree: true);
        lock (output) return new PlayerFailedException($"the player of '{Build.Folder}' {what}:\n{output}");
    }

    private static int Int(string word) => int.Parse(word, CultureInfo.InvariantCulture);
}
