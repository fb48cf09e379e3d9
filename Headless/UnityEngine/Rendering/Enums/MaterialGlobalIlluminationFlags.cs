using System;

namespace UnityEngine;

[Flags]
public enum MaterialGlobalIlluminationFlags
{
    None = 0,
    RealtimeEmissive = 1,
    BakedEmissive = 2,
    AnyEmissive = 3,
    EmissiveIsBlack = 4,
}
