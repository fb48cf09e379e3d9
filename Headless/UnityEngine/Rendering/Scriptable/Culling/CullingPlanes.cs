using System;
using System.Runtime.CompilerServices;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Up to ten planes with normals that point inwards, compared by value.</summary>
[InlineArray(Count)]
internal struct CullingPlanes : IEquatable<CullingPlanes>
{
    public const int Count = 10;

    private Plane first;

    public readonly bool Equals(CullingPlanes other)
    {
        for (int i = 0; i < Count; i++)
        {
            if (this[i].normal != other[i].normal || this[i].distance != other[i].distance)
            {
                return false;
            }
        }

        return true;
    }

    public override readonly bool Equals(object? obj) => obj is CullingPlanes other && Equals(other);

    public override readonly int GetHashCode() => HashCode.Combine(first.normal, first.distance);
}
