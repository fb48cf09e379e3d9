using System;

namespace UnityEngine;

public readonly struct GraphicsBufferHandle : IEquatable<GraphicsBufferHandle>
{
    public readonly uint value;

    internal GraphicsBufferHandle(uint value) => this.value = value;

    public static bool operator ==(GraphicsBufferHandle a, GraphicsBufferHandle b) => a.value == b.value;

    public static bool operator !=(GraphicsBufferHandle a, GraphicsBufferHandle b) => a.value != b.value;

    public int CompareTo(GraphicsBufferHandle other) => value.CompareTo(other.value);

    public bool Equals(GraphicsBufferHandle other) => value == other.value;

    public override bool Equals(object? obj) => obj is GraphicsBufferHandle other && Equals(other);

    public override int GetHashCode() => value.GetHashCode();
}
