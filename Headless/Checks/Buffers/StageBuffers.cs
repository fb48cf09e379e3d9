using Headless.Shaders;

namespace Headless.Checks.Buffers;

/// <summary>The storage buffers of a compiled stage: those that its code reads or writes, whatever its file declares.</summary>
internal sealed record StageBuffers(string Stage, int Count, int Written)
{
    public static StageBuffers Of(ShaderBinary binary) => new(
        binary.Stage.ToString().ToLowerInvariant(), binary.Resources.Count(r => Reads(r.Kind) || Writes(r.Kind)), binary.Resources.Count(r => Writes(r.Kind)));

    private static bool Reads(ResourceKind kind) => kind is ResourceKind.StructuredBuffer or ResourceKind.ByteAddressBuffer;

    private static bool Writes(ResourceKind kind) => kind is ResourceKind.RWStructuredBuffer or ResourceKind.RWByteAddressBuffer or ResourceKind.Counter;
}
