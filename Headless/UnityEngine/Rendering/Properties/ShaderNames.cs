using System.Collections.Generic;
using System.Threading;
using System;

namespace Headless.Engine;

/// <summary>Numbers of shader property names; the same text always has the same number.</summary>
internal static class ShaderNames
{
    private static readonly Dictionary<string, int> Ids = new(StringComparer.Ordinal);
    private static readonly List<string> Names = [];
    private static readonly Lock Gate = new();

    public static int Id(string name)
    {
        ArgumentNullException.ThrowIfNull(name);
        lock (Gate)
        {
            if (!Ids.TryGetValue(name, out int id))
            {
                id = Names.Count;
                Names.Add(name);
                Ids.Add(name, id);
            }

            return id;
        }
    }

    public static string Name(int id)
    {
        lock (Gate)
        {
            return id >= 0 && id < Names.Count ? Names[id] : $"<unknown property {id}>";
        }
    }
}
