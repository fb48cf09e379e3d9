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
}
