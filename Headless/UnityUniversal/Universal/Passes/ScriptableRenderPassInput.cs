using System;

namespace UnityEngine.Rendering.Universal;

[Flags]
public enum ScriptableRenderPassInput
{
    None = 0,
    Depth = 1 << 0,
    Normal = 1 << 1,
    Color = 1 << 2,
    Motion = 1 << 3,
}
