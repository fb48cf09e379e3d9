namespace Headless.Vulkan;

/// <summary>What a buffer may be bound as; copying to and from it is always allowed.</summary>
[Flags]
public enum BufferUse
{
    /// <summary>Source and target of copies only.</summary>
    Transfer = 0,

    /// <summary>StructuredBuffer, ByteAddressBuffer and their RW forms.</summary>
    Storage = 1,

    /// <summary>Arguments of indirect dispatches and draws.</summary>
    Indirect = 2,

    /// <summary>Vertex stream.</summary>
    Vertex = 4,

    /// <summary>Index stream.</summary>
    Index = 8,

    /// <summary>Constant buffer.</summary>
    Uniform = 16,
}
