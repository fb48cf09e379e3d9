using System.Collections.Generic;
using System.Linq;
using System;
using Headless.Shaders;

namespace Headless.Engine;

/// <summary>Keywords enabled on one material or compute shader, and the variant they select.</summary>
internal sealed class KeywordState
{
    private readonly HashSet<string> enabled = new(StringComparer.Ordinal);
    private int version;

    public int Version => version;
    public IReadOnlyCollection<string> Enabled => enabled;
    public HashSet<string> Set => enabled;

    public bool IsEnabled(string keyword) => enabled.Contains(keyword);

    public void Change(string keyword, bool value)
    {
        ArgumentNullException.ThrowIfNull(keyword);
        if (value ? enabled.Add(keyword) : enabled.Remove(keyword))
        {
            version++;
        }
    }

    public void Replace(IEnumerable<string> keywords)
    {
        enabled.Clear();
        enabled.UnionWith(keywords.Where(k => !string.IsNullOrEmpty(k)));
        version++;
    }
}
