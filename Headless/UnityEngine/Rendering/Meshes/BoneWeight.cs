using System;

namespace UnityEngine;

public struct BoneWeight : IEquatable<BoneWeight>
{
    public int boneIndex0 { get; set; }
    public int boneIndex1 { get; set; }
    public int boneIndex2 { get; set; }
    public int boneIndex3 { get; set; }
    public float weight0 { get; set; }
    public float weight1 { get; set; }
    public float weight2 { get; set; }
    public float weight3 { get; set; }

    public static bool operator ==(BoneWeight lhs, BoneWeight rhs) => lhs.Equals(rhs);

    public static bool operator !=(BoneWeight lhs, BoneWeight rhs) => !lhs.Equals(rhs);

    public readonly bool Equals(BoneWeight other) =>
        (boneIndex0, boneIndex1, boneIndex2, boneIndex3) == (other.boneIndex0, other.boneIndex1, other.boneIndex2, other.boneIndex3) &&
        (weight0, weight1, weight2, weight3) == (other.weight0, other.weight1, other.weight2, other.weight3);

    public override readonly bool Equals(object? other) => other is BoneWeight weight && Equals(weight);

    public override readonly int GetHashCode() => HashCode.Combine(boneIndex0, boneIndex1, boneIndex2, boneIndex3, weight0, weight1, weight2, weight3);
}
