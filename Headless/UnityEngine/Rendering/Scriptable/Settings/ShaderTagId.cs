using System;
using Headless.Engine;

namespace UnityEngine.Rendering;

/// <summary>The number of a tag name or value in shaders.</summary>
public struct ShaderTagId : IEquatable<ShaderTagId>
{
    public static readonly ShaderTagId none;

    // 0 is no tag.
    private readonly int number;

    public ShaderTagId(string name) => number = ShaderNames.Id(name) + 1;

    public readonly string name => number == 0 ? string.Empty : ShaderNames.Name(number - 1);

    public static explicit operator ShaderTagId(string name) => new(name);

    public static explicit operator string(ShaderTagId tagId) => tagId.name;

    public static bool operator ==(ShaderTagId tag1, ShaderTagId tag2) => tag1.Equals(tag2);

    public static bool operator !=(ShaderTagId tag1, ShaderTagId tag2) => !tag1.Equals(tag2);

    public readonly bool Equals(ShaderTagId other) => number == other.number;

    public override readonly bool Equals(object? obj) => obj is ShaderTagId other && Equals(other);

    public override readonly int GetHashCode() => number;
}
