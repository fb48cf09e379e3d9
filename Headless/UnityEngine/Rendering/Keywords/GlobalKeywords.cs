using System.Collections.Generic;
using System.Linq;

namespace Headless.Engine;

/// <summary>Keywords that are on for every shader.</summary>
internal static class GlobalKeywords
{
    private static readonly HashSet<string> Known = [];
    private static readonly HashSet<string> On = [];

    /// <summary>Grows with every change, so that chosen variants can be kept until then.</summary>
    public static int Version { get; private set; }

    public static IReadOnlyCollection<string> All => Known;
    public static IReadOnlyCollection<string> Enabled => On;

    public static void Declare(string keyword) => Known.Add(keyword);

    public static bool IsEnabled(string keyword) => On.Contains(keyword);

    public static void Set(string keyword, bool value)
    {
        Known.Add(keyword);
        if (value ? On.Add(keyword) : On.Remove(keyword))
        {
            Version++;
        }
    }

    public static void Clear()
    {
        On.Clear();
        Version++;
    }
}
