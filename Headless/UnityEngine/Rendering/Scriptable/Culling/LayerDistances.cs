using System;
using System.Runtime.CompilerServices;

namespace Headless.Engine;

/// <summary>A distance a layer, 0 for that of the far plane; compared by value.</summary>
[InlineArray(Count)]
internal struct LayerDistances : IEquatable<LayerDistances>
{
    public const int Count = 32;

    private float first;

    public readonly bool Equals(LayerDistances other) => ((ReadOnlySpan<float>)this).SequenceEqual(other);

    public override readonly bool Equals(object? obj) => obj is LayerDistances other && Equals(other);

    public override readonly int GetHashCode() => first.GetHashCode();
}
