using System;

namespace UnityEngine.Rendering.RenderGraphModule;

[Flags]
public enum AccessFlags
{
    None = 0,
    Read = 1 << 0,
    Write = 1 << 1,
    Discard = 1 << 2,
    WriteAll = Write | Discard,
    ReadWrite = Read | Write,
}
