namespace Headless.Engine;

/// <summary>The view of a buffer that Unity makes for shaders on Direct3D 11.</summary>
internal enum BufferView
{
    /// <summary>None: shaders cannot reach it.</summary>
    None,

    /// <summary>(RW)StructuredBuffer of the buffer's stride.</summary>
    Structured,

    /// <summary>(RW)ByteAddressBuffer.</summary>
    Raw,

    /// <summary>RWBuffer&lt;uint&gt; to write, ByteAddressBuffer to read: what IndirectArguments alone gives.</summary>
    Arguments,
}
