using System.Collections.Generic;
using System.Linq;
using System;
using Headless.Shaders;

namespace Headless.Engine;

/// <summary>Chooses the variant of a program: from every keyword line the first that is enabled, else the line's default.</summary>
internal sealed class KeywordSelection(IReadOnlyList<KeywordSet> sets)
{
    private readonly string[] names = [.. sets.SelectMany(s => s.Keywords).Where(k => k.Length > 0).Distinct()];

    public IReadOnlyList<string> Names => names;

    public bool Declares(string keyword) => Array.IndexOf(names, keyword) >= 0;

    /// <summary>The active keywords, which are also the variant's key when joined.</summary>
    public string[] Select(HashSet<string> local)
    {
        if (sets.Count == 0)
        {
            return [];
        }

        var active = new List<string>(sets.Count);
        foreach (KeywordSet set in sets)
        {
            string? chosen = set.Keywords.FirstOrDefault(k => k.Length > 0 && IsOn(k, set.Local, local));
            chosen ??= set.Keywords.Contains("") ? "" : set.Feature && set.Keywords.Count == 1 ? "" : set.Keywords[0];
            if (chosen.Length > 0 && !active.Contains(chosen))
            {
                active.Add(chosen);
            }
        }

        active.Sort(StringComparer.Ordinal);
        return [.. active];
    }

    private static bool IsOn(string keyword, bool localOnly, HashSet<string> local) =>
        local.Contains(keyword) || (!localOnly && GlobalKeywords.IsEnabled(keyword));
}
