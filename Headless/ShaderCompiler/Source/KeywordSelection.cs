namespace Headless.Shaders;

/// <summary>Picks one keyword of every set.</summary>
internal static class KeywordSelection
{
    /// <summary>Keywords to define, in order of declaration; ones that no set declares are left out, as Unity does.</summary>
    /// <param name="needsChoice">
    /// Compute: a set without an empty option needs an enabled keyword. Passes take the first keyword instead.
    /// </param>
    public static IReadOnlyList<string> Choose(
        IReadOnlyList<KeywordSet> sets, IReadOnlyCollection<string> enabled, bool needsChoice, string file)
    {
        List<string> chosen = [];
        foreach (KeywordSet set in sets)
        {
            string? keyword = set.Keywords.FirstOrDefault(k => k.Length > 0 && enabled.Contains(k))
                ?? (set.Keywords.Contains("") ? "" : null);
            if (keyword is null && needsChoice)
            {
                throw new ShaderCompileException(
                    file, 0, $"none of the keywords {string.Join(", ", set.Keywords)} is enabled; enable one or add \"_\" to the set");
            }
            keyword ??= set.Keywords[0];
            if (keyword.Length > 0 && !chosen.Contains(keyword))
            {
                chosen.Add(keyword);
            }
        }
        return chosen;
    }
}
