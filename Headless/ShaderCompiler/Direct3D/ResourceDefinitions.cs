using System.Buffers.Binary;
using System.Text;

namespace Headless.Shaders.Direct3D;

/// <summary>Reads the chunk RDEF of a Direct3D shader: which name has which register, and what is in the constant buffers.</summary>
/// <remarks>
/// The chunk holds what D3D11_SHADER_INPUT_BIND_DESC and D3D11_SHADER_VARIABLE_DESC hold (d3d11shader.h); offsets count from its
/// start. Numbers below are those of D3D_SHADER_INPUT_TYPE, D3D_SRV_DIMENSION and D3D_RESOURCE_RETURN_TYPE (d3dcommon.h).
/// </remarks>
internal sealed class ResourceDefinitions
{
    private const int BindingSize = 32;
    private const int BufferSize = 24;
    private const uint ComparisonFlag = 2;

    private readonly ReadOnlyMemory<byte> _chunk;

    /// <exception cref="InvalidDataException">The chunk is damaged, or names a resource that the headless player does not support.</exception>
    public ResourceDefinitions(ReadOnlyMemory<byte> chunk)
    {
        _chunk = chunk;
        try
        {
            Resources = [.. Enumerable.Range(0, Number(8)).Select(i => Resource(Number(12) + i * BindingSize))];
            Buffers = Enumerable.Range(0, Number(0)).Select(i => Number(4) + i * BufferSize)
                .GroupBy(Name)
                .ToDictionary(g => g.Key, g => Buffer(g.First()));
        }
        catch (ArgumentOutOfRangeException)
        {
            throw new InvalidDataException("the resource definitions of a Direct3D shader are damaged");
        }
    }

    public IReadOnlyList<DxbcResource> Resources { get; }

    /// <summary>Bytes and members of each constant buffer by its name. Structured buffers are listed as well.</summary>
    public IReadOnlyDictionary<string, (int Size, IReadOnlyList<ConstantMember> Members)> Buffers { get; }

    // name, input type, return type, dimension, samples or stride, register, count, flags
    private DxbcResource Resource(int at)
    {
        string name = Name(at);
        (ResourceKind kind, string letter) = Number(at + 4) switch
        {
            0 => (ResourceKind.ConstantBuffer, "cb"),
            2 => (ResourceKind.Texture, "t"),
            3 => (ResourceKind.Sampler, "s"),
            4 => (ResourceKind.RWTexture, "u"),
            5 => (ResourceKind.StructuredBuffer, "t"),
            6 => (ResourceKind.RWStructuredBuffer, "u"),
            7 => (ResourceKind.ByteAddressBuffer, "t"),
            8 => (ResourceKind.RWByteAddressBuffer, "u"),
            int other => throw new InvalidDataException(
                $"'{name}' is a resource of a kind that the headless player does not support (D3D_SHADER_INPUT_TYPE {other})"),
        };
        bool texture = kind is ResourceKind.Texture or ResourceKind.RWTexture;
        bool raw = kind is ResourceKind.ByteAddressBuffer or ResourceKind.RWByteAddressBuffer;
        bool structured = kind is ResourceKind.StructuredBuffer or ResourceKind.RWStructuredBuffer;
        return new DxbcResource(
            name, kind, letter + Number(at + 20),
            texture ? Dimension(name, Number(at + 12)) : "",
            texture ? SampledType(Number(at + 8)) : "",
            structured ? Number(at + 16) : raw ? 4 : 0,
            Number(at + 24),
            kind == ResourceKind.Sampler && (Number(at + 28) & ComparisonFlag) != 0);
    }

    private static string Dimension(string name, int number) => number switch
    {
        2 => "1D",
        3 => "1DArray",
        4 => "2D",
        5 => "2DArray",
        6 => "2DMS",
        7 => "2DArrayMS",
        8 => "3D",
        9 => "Cube",
        10 => "CubeArray",
        1 or 11 => throw new InvalidDataException(
            $"'{name}' is a typed buffer (Buffer<T>, RWBuffer<T>), which is not supported; use a structured buffer"),
        _ => throw new InvalidDataException($"'{name}' has the unknown dimension {number}"),
    };

    private static string SampledType(int number) => number switch { 3 => "int", 4 => "uint", _ => "float" };

    // name, number of variables, variables, size
    private (int Size, IReadOnlyList<ConstantMember> Members) Buffer(int at)
    {
        int variableSize = IsShaderModel5 ? 40 : 24;
        List<ConstantMember> members = [];
        for (int i = 0; i < Number(at + 4); i++)
        {
            // name, offset, size, flags, type
            int variable = Number(at + 8) + i * variableSize;
            new DxbcType(_chunk, Number(variable + 16)).AddMembers(members, Name(variable), Number(variable + 4));
        }
        return (Number(at + 12), members);
    }

    // "RD11" stands behind the creator's offset.
    private bool IsShaderModel5 => _chunk.Span[28..].StartsWith("RD11"u8);

    private int Number(int at) => BinaryPrimitives.ReadInt32LittleEndian(_chunk.Span[at..]);

    private string Name(int at) => Text(_chunk.Span[Number(at)..]);

    internal static string Text(ReadOnlySpan<byte> bytes) => Encoding.UTF8.GetString(bytes[..bytes.IndexOf((byte)0)]);
}
