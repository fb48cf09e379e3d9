using System.Collections.Generic;
using System;
using System.Linq;

namespace Headless.Engine;

/// <summary>Which kernel variants were dispatched, for a test run that records what each test covers.</summary>
internal static class KernelUse
{
    private static HashSet<string>? seen;

    /// <summary>Starts the record; before this nothing is kept.</summary>
    public static void Begin() => seen = new HashSet<string>(StringComparer.Ordinal);

    public static void Add(ComputeVariant variant) => seen?.Add(variant.Label);

    /// <summary>The variants since the last call, in ordinal order: "path of the shader|kernel|keywords".</summary>
    public static IReadOnlyList<string> Take()
    {
        if (seen is null)
        {
            return [];
        }

        string[] taken = [.. seen.Order(StringComparer.Ordinal)];
        seen.Clear();
        return taken;
    }
}
