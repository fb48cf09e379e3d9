namespace Headless.Shaders;

public enum ResourceKind
{
    ConstantBuffer,
    StructuredBuffer,
    RWStructuredBuffer,
    ByteAddressBuffer,
    RWByteAddressBuffer,
    Texture,
    RWTexture,
    Sampler,

    /// <summary>The hidden counter of an append, consume or counted buffer; its name is the buffer's and "@count".</summary>
    Counter,
}
