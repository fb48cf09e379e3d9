using System;

namespace UnityEngine.Rendering;

[Flags]
public enum CommandBufferExecutionFlags
{
    None = 0,
    AsyncCompute = 2,
}
