using System.Buffers.Binary;

namespace Headless.Shaders.Direct3D;

/// <summary>A type in the resource definitions of a Direct3D shader (D3D11_SHADER_TYPE_DESC).</summary>
/// <remarks>
/// In a constant buffer matrix columns and array elements begin at rows of 16 bytes: float3x2 m[2], column-major, takes the rows
/// 0 and 1 for m[0], 2 and 3 for m[1]; its stride is 32, its last byte 2 * 32 - 4.
/// </remarks>
internal readonly struct DxbcType
{
    private const int Row = 16, MemberSize = 12;
    private const int RowMajorMatrix = 2, ColumnMajorMatrix = 3, StructClass = 5;

    private readonly ReadOnlyMemory<byte> _chunk;
    private readonly int _at;

    // class, base type, rows, columns, elements, members: 16 bits each; offset of the members
    public DxbcType(ReadOnlyMemory<byte> chunk, int at)
    {
        _chunk = chunk;
        _at = at;
    }

    private int Class => Short(0);
    private int Rows => Short(4);
    private int Columns => Short(6);
    private int Elements => Short(8);
    private int MemberCount => Short(10);
    private bool IsMatrix => Class is RowMajorMatrix or ColumnMajorMatrix;

    private string Scalar => Short(2) switch
    {
        1 or 19 => "uint",
        2 => "int",
        39 => "double",
        _ => "float",
    };

    /// <summary>Adds the members that a variable of this type has; one, unless it is a struct.</summary>
    public void AddMembers(List<ConstantMember> members, string name, int offset)
    {
        int element = ElementSize();
        int stride = Elements > 0 ? (element + Row - 1) / Row * Row : 0;
        if (Class != StructClass)
        {
            int size = element + Math.Max(0, Elements - 1) * stride;
            members.Add(new ConstantMember(name, offset, size, Elements, stride, Scalar, IsMatrix, Rows, Columns)
            {
                RowMajor = Class == RowMajorMatrix,
            });
            return;
        }
        for (int i = 0; i < Math.Max(1, Elements); i++)
        {
            string path = Elements > 0 ? $"{name}[{i}]" : name;
            foreach ((string member, DxbcType type, int start) in Members())
            {
                type.AddMembers(members, $"{path}.{member}", offset + i * stride + start);
            }
        }
    }

    private IEnumerable<(string Name, DxbcType Type, int Offset)> Members()
    {
        int first = Number(_at + 12);
        for (int i = 0; i < MemberCount; i++)
        {
            int at = first + i * MemberSize;
            yield return (ResourceDefinitions.Text(_chunk.Span[Number(at)..]), new DxbcType(_chunk, Number(at + 4)), Number(at + 8));
        }
    }

    // Without the padding behind the last value.
    private int ElementSize()
    {
        int scalar = Scalar == "double" ? 8 : 4;
        return Class switch
        {
            StructClass => Members().Max(m => m.Offset + m.Type.WholeSize()),
            RowMajorMatrix => (Rows - 1) * Row + Columns * scalar,
            ColumnMajorMatrix => (Columns - 1) * Row + Rows * scalar,
            _ => Columns * scalar,
        };
    }

    private int WholeSize()
    {
        int element = ElementSize();
        return element + Math.Max(0, Elements - 1) * ((element + Row - 1) / Row * Row);
    }

    private int Short(int at) => BinaryPrimitives.ReadUInt16LittleEndian(_chunk.Span[(_at + at)..]);

    private int Number(int at) => BinaryPrimitives.ReadInt32LittleEndian(_chunk.Span[at..]);
}
