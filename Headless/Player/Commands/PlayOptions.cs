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
    private const double DefaultSeconds = 1.5, DefaultFps = 24;
    private const string DefaultSize = "960x540", DefaultFolder = "Build/play";

    internal static readonly IReadOnlyList<Flag> Flags =
    [
        CommonFlags.Project, CommonFlags.Assemblies,
        new("--scene", "FILE.unity", "scene to play; ./run takes the name of a sample, too", "Dam Break, of the samples"),
        new("--seconds", "S", "simulated seconds", Text(DefaultSeconds)),
        new("--fps", "F", "frames a simulated second, and of the film", Text(DefaultFps)),
        new("--size", "WxH", "size of the pictures in pixels", DefaultSize),
        new("--out", "DIR", "folder for the output", DefaultFolder),
        CommonFlags.Device, CommonFlags.Pipeline,
        new("--stereo", "HOW", "two eyes side by side in each picture", "one eye") { Choices = StereoChoice.Names },
        Flag.Switch("--no-images", "no pictures and no film, only figures"),
        Flag.Switch("--open", "shows the film at the end, with the desktop's program for films"),
        Flag.Switch("--twice", "plays it again without a domain reload, and fails where a picture differs"),
        CommonFlags.Validate,
        Flag.Switch("--unset", "lists what shaders read and nothing has set"),
        CommonFlags.ExecuteMethod("called before the scene is loaded"),
    ];

    public required string Project { get; init; }
    public required string Scene { get; init; }
    public string? Assemblies { get; init; }
    public double Seconds { get; init; } = DefaultSeconds;
    public double Fps { get; init; } = DefaultFps;
    public int Width { get; init; }
    public int Height { get; init; }
    public string Out { get; init; } = DefaultFolder;
    public string? Device { get; init; }

    /// <summary>Name of the render pipeline; null for the project's.</summary>
    public string? Pipeline { get; init; }

    /// <summary>How two eyes are drawn; null for one.</summary>
    public string? Stereo { get; init; }

    public string? ExecuteMethod { get; init; }
    public bool Images { get; init; } = true;
    public bool Validate { get; init; }

    /// <summary>Whether shader properties that were read unset are listed at the end.</summary>
    public bool Unset { get; init; }

    /// <summary>Whether the scene is played a second time in the same process, which must show the same pictures.</summary>
    public bool Twice { get; init; }

    /// <summary>Whether the film is shown at the end.</summary>
    public bool Open { get; init; }

    /// <summary>Frames from time 0 to the last second, both shown: 2 s at 24 frames a second are 49 frames.</summary>
    public int Frames => Math.Max(1, (int)Math.Round(Seconds * Fps)) + 1;

    public static PlayOptions Parse(IReadOnlyList<string> words)
    {
        var arguments = new Arguments("play", words, Flags);
        (int width, int height) = Size(arguments.Text("--size", DefaultSize));
        var options = new PlayOptions
        {
            Project = arguments.Folder("--project"),
            Scene = arguments.Required("--scene"),
            Assemblies = arguments.Has("--assemblies") ? arguments.Folder("--assemblies") : null,
            Seconds = arguments.Number("--seconds", DefaultSeconds, 0.001, 86400, "seconds"),
            Fps = arguments.Number("--fps", DefaultFps, 0.01, 1000, "frames a second"),
            Width = width,
            Height = height,
            Out = arguments.Text("--out", DefaultFolder),
            Device = arguments.Text("--device"),
            Pipeline = arguments.Text("--pipeline"),
            Stereo = arguments.Text("--stereo"),
            ExecuteMethod = arguments.Text("--executeMethod"),
            Images = !arguments.Has("--no-images"),
            Validate = arguments.Has("--validate"),
            Unset = arguments.Has("--unset"),
            Open = arguments.Has("--open"),
            Twice = arguments.Has("--twice"),
        };
        if (options.Seconds * options.Fps > MaximumFrames)
            throw new UsageException(string.Create(CultureInfo.InvariantCulture, $"--seconds {options.Seconds} at --fps {options.Fps} are more than {MaximumFrames} frames; play less time or fewer frames a second."));
        if (options.Open && !options.Images) throw new UsageException("--open shows a film, and --no-images makes none: give one of them.");
        if (options.Twice && !options.Images) throw new UsageException("--twice compares pictures, and --no-images makes none: give one of them.");
        if (!options.Scene.EndsWith(".unity", StringComparison.Ordinal)) throw new UsageException($"--scene must be a .unity file, found '{OneLine.Value(options.Scene)}'.");
        return options;
    }

    private static string Text(double number) => number.ToString(CultureInfo.InvariantCulture);

    private static (int, int) Size(string text)
    {
        string[] parts = text.Split('x');
        if (parts.Length == 2 && Side(parts[0], out int width) && Side(parts[1], out int height) && width * height <= MaximumPixels) return (width, height);
        throw new UsageException($"--size must be WxH in pixels, each 1 to {MaximumSide} and {MaximumPixels} in all, as 1280x720; found '{OneLine.Value(text)}'.");
    }

    private static bool Side(string text, out int value) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out value) && value is >= 1 and <= MaximumSide;
}
