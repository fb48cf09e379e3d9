namespace Headless.Shaders;

/// <summary>Words of render state commands and their numbers in UnityEngine.Rendering.</summary>
internal static class RenderStateNames
{
    public static readonly Dictionary<string, float> OnOff = Table(("Off", 0), ("On", 1), ("False", 0), ("True", 1));

    public static readonly Dictionary<string, float> Cull = Table(("Off", 0), ("Front", 1), ("Back", 2));

    public static readonly Dictionary<string, float> Compare = Table(
        ("Off", 0), ("Disabled", 0), ("Never", 1), ("Less", 2), ("Equal", 3), ("LEqual", 4), ("Greater", 5), ("NotEqual", 6),
        ("GEqual", 7), ("Always", 8));

    public static readonly Dictionary<string, float> Factor = Table(
        ("Zero", 0), ("One", 1), ("DstColor", 2), ("SrcColor", 3), ("OneMinusDstColor", 4), ("SrcAlpha", 5), ("OneMinusSrcColor", 6),
        ("DstAlpha", 7), ("OneMinusDstAlpha", 8), ("SrcAlphaSaturate", 9), ("OneMinusSrcAlpha", 10));

    public static readonly Dictionary<string, float> Operation =
        Table(("Add", 0), ("Sub", 1), ("RevSub", 2), ("Min", 3), ("Max", 4));

    private static Dictionary<string, float> Table(params (string Name, float Value)[] entries) =>
        entries.ToDictionary(e => e.Name, e => e.Value, StringComparer.OrdinalIgnoreCase);
}
