using System;
using System.Collections.Generic;

namespace Headless.Engine;

/// <summary>What shaders read while nothing has set it: numbers are zeros then, textures empty ones. Kept where someone wants to see it.</summary>
internal static class UnsetProperties
{
    private static SortedSet<string>? found;
    private static string reader = string.Empty;

    /// <summary>"shader, pass: property", each once.</summary>
    public static IReadOnlyCollection<string> Found => found ?? [];

    public static void Watch() => found ??= new SortedSet<string>(StringComparer.Ordinal);

    public static void Forget() => found = null;

    public static void ReadBy(PassProgram pass)
    {
        if (found is not null)
        {
            reader = $"{pass.Source.ShaderName}, {pass.Source.Name}";
        }
    }

    public static void Note(int property) => found?.Add($"{reader}: {ShaderNames.Name(property)}");
}
