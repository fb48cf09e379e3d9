using Headless.Engine;

namespace Headless.Player;

/// <summary>Two eyes side by side in each picture, by the name of how they are drawn.</summary>
internal static class StereoChoice
{
    public const string MultiPass = "multi-pass", Instanced = "instanced";

    public static IReadOnlyList<string> Names { get; } = [MultiPass, Instanced];

    /// <param name="name">Null for one eye.</param>
    public static void Apply(string? name) => Stereo.Mode = name switch
    {
        MultiPass => StereoMode.MultiPass,
        Instanced => StereoMode.Instanced,
        _ => StereoMode.Off,
    };
}
