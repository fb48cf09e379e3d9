using System;
using System.Runtime.CompilerServices;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>The pass names of a DrawingSettings, compared by value.</summary>
[InlineArray(Count)]
internal struct ShaderPassNames : IEquatable<ShaderPassNames>
{
    public const int Count = 16;

    private ShaderTagId first;

    public readonly bool Equals(ShaderPassNames other) => ((ReadOnlySpan<ShaderTagId>)this).SequenceEqual(other);

    public override readonly bool Equals(object? obj) => obj is ShaderPassNames other && Equals(other);

    public override readonly int GetHashCode() => first.GetHashCode();
}
