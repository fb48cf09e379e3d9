namespace Headless.Checks.Api;

/// <summary>A line of Unity whose public API is at hand; what is found against an alpha is noted and fails nothing.</summary>
/// <param name="Name">As in the lists' headers.</param>
/// <param name="IsAlpha">Whether its API may still change.</param>
/// <param name="HasRenderPipelinesBetween">Whether its render pipelines, which have no list, lie between those of its own list and of the next line's.</param>
internal sealed record UnityLine(string Name, bool IsAlpha = false, bool HasRenderPipelinesBetween = false)
{
    /// <summary>The lines that the packages are compiled against, the oldest first: those of the lists' headers.</summary>
    public static IReadOnlyList<UnityLine> All { get; } =
        [new("2022.3"), new("6000.0"), new("6000.3", HasRenderPipelinesBetween: true), new("6000.5"), new("6000.7", IsAlpha: true)];

    // Releases with a define of their own, of which a line has those up to its own.
    private static readonly string[] releases =
    [
        "5.3", "2021.3", "2022.1", "2022.2", "2022.3", "2023.1", "2023.2", "2023.3",
        "6000.0", "6000.1", "6000.2", "6000.3", "6000.4", "6000.5", "6000.6", "6000.7",
    ];

    /// <summary>What the Editor defines for scripts, on Windows.</summary>
    /// <param name="editor">Whether it compiles for itself, or for a player.</param>
    public IEnumerable<string> Defines(bool editor)
    {
        var own = Name.Replace('.', '_');
        string[] platform = ["UNITY_" + own, "UNITY_" + own.Split('_')[0], "UNITY_STANDALONE", "UNITY_STANDALONE_WIN", "NET_STANDARD_2_1", "NET_STANDARD", "ENABLE_MONO"];
        string[] ofEditor = ["UNITY_EDITOR", "UNITY_EDITOR_WIN", "UNITY_INCLUDE_TESTS", "ENABLE_PROFILER"];
        return releases.Take(Array.IndexOf(releases, Name) + 1).Select(r => $"UNITY_{r.Replace('.', '_')}_OR_NEWER").Concat(platform).Concat(editor ? ofEditor : []);
    }

    public override string ToString() => Name;
}
