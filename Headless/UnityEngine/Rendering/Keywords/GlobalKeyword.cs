using System;
using Headless.Engine;

namespace UnityEngine.Rendering;

public readonly struct GlobalKeyword
{
    public GlobalKeyword(string name)
    {
        ArgumentNullException.ThrowIfNull(name);
        this.name = name;
    }

    public string name { get; }

    public static GlobalKeyword Create(string name)
    {
        GlobalKeywords.Declare(name);
        return new GlobalKeyword(name);
    }

    public override string ToString() => name;
}
