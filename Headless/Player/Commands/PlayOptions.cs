using System.Globalization;
using Headless.Files;

namespace Headless.Player.Commands;

/// <summary>Flags of <c>sphplayer play</c>.</summary>
public sealed record PlayOptions
{
    private const int MaximumSide = 16384;

    /// <summary>Those of 8K; device and computer hold a picture several times.</summary>
    private const int MaximumPixels = 7680 * 4320;
    private const int MaximumFrames = 1_000_000;
    private static readonly string[] WithValue = ["--project", "--scene", "--assemblies", "--seconds", "--fps", "--size", "--out", "--device", "--executeMethod"];
    private static readonly string[] Switches = ["--no-images", "--validate"];

    public required string Project { get; init; }
    public required string Scene { get; init; }
    public string? Assemblies { get; init; }
    public double Seconds { get; init; } = 3;
    public double Fps { get; init; } = 30;
    public int Width { get; init; } = 1280;
    public int Height { get; init; } = 720;
    public string Out { get; init; } = "Build/play";
    public string? Device { get; init; }
    public string? ExecuteMethod { get; init; }
    public bool Images { get; init; } = true;
    public bool Validate { get; init; }

    /// <summary>Frames from time 0 to the last second, both shown: 3 s at 30 frames a second are 91 frames.</summary>
    public int Frames => Math.Max(1, (int)Math.Round(Seconds * Fps)) + 1;

    public static PlayOptions Parse(IReadOnlyList<string> words)
    {
        var arguments = new Arguments("play", words, WithValue, Switches);
        (int width, int height) = Size(arguments.Text("--size", "1280x720"));
        var options = new PlayOptions
        {
            Project = arguments.Folder("--project"),
            Scene = arguments.Required("--scene"),
            Assemblies = arguments.Has("--assemblies") ? arguments.Folder("--assemblies") : null,
            Seconds = arguments.Number("--seconds", 3, 0.001, 86400, "seconds"),
            Fps = arguments.Number("--fps", 30, 0.01, 1000, "frames a second"),
            Width = width,
            Height = height,
            Out = arguments.Text("--out", "Build/play"),
            Device = arguments.Text("--device"),
            ExecuteMethod = arguments.Text("--executeMethod"),
            Images = !arguments.Has("--no-images"),
            Validate = arguments.Has("--validate"),
        };
        if (options.Seconds * options.Fps > MaximumFrames)
            throw new UsageException(string.Create(CultureInfo.InvariantCulture, $"--seconds {options.Seconds} at --fps {options.Fps} are more than {MaximumFrames} frames; play less time or fewer frames a second."));
        if (!options.Scene.EndsWith(".unity", StringComparison.Ordinal)) throw new UsageException($"--scene must be a .unity file, found '{OneLine.Value(options.Scene)}'.");
        return options;
    }

    private static (int, int) Size(string text)
    {
        string[] parts = text.Split('x');
        if (parts.Length == 2 && Side(parts[0], out int width) && Side(parts[1], out int height) && width * height <= MaximumPixels) return (width, height);
        throw new UsageException($"--size must be WxH in pixels, each 1 to {MaximumSide} and {MaximumPixels} in all, as 1280x720; found '{OneLine.Value(text)}'.");
    }

    private static bool Side(string text, out int value) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out value) && value is >= 1 and <= MaximumSide;
}
