namespace UnityEngine;

public enum SkinQuality
{
    Auto = 0,
    Bone1 = 1,
    Bone2 = 2,
    Bone4 = 4,
}
