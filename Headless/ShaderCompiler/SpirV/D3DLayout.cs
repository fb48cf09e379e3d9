namespace Headless.Shaders.SpirV;

/// <summary>Gives uniform and storage blocks the memory layout of D3D11.</summary>
/// <remarks>
/// Constant buffers: a vector does not cross a 16-byte row; arrays, matrices and structs begin at a row; array elements and
/// matrix columns are a row multiple apart; what follows may use the rest of the last row ("Packing rules for constant
/// variables", Microsoft HLSL reference). Structured buffers: every scalar directly follows the one before, so
/// struct { float3 a; float b[3]; } has a stride of 24.
/// SPIR-V holds HLSL's matrices transposed: its RowMajor is HLSL's column_major, its columns are HLSL's rows.
/// </remarks>
internal sealed class D3DLayout(SpirVIndex index)
{
    private const int Row = 16;

    private readonly Dictionary<uint, bool> _rules = [];
    private bool _writing;

    /// <summary>Runtime arrays whose stride was another one before.</summary>
    public HashSet<uint> ChangedStrides { get; } = [];

    /// <summary>Writes offsets and strides of every block.</summary>
    /// <param name="keepConstantOffsets">Leaves constant buffers as they are (a source with packoffset).</param>
    public void Apply(bool keepConstantOffsets)
    {
        _writing = true;
        foreach (SpirVInstruction variable in index.Variables)
        {
            if ((SpirVStorage)variable[2] is not (SpirVStorage.Uniform or SpirVStorage.StorageBuffer))
            {
                continue;
            }
            uint type = index.Pointee(variable);
            while (index.Definition(type).Op is SpirVOp.TypeArray)
            {
                type = index.Definition(type)[1];
            }
            bool constant = index.Has(type, SpirVDecoration.Block) && (SpirVStorage)variable[2] == SpirVStorage.Uniform;
            if (!constant || !keepConstantOffsets)
            {
                Size(type, constant, rowMajor: true);
            }
        }
        _writing = false;
    }

    /// <summary>Bytes from the first to the last one used.</summary>
    /// <param name="rowMajor">SPIR-V's RowMajor for matrices in this type.</param>
    public int Size(uint type, bool constant, bool rowMajor)
    {
        SpirVInstruction definition = index.Definition(type);
        switch (definition.Op)
        {
            case SpirVOp.TypeBool:
                return 4;
            case SpirVOp.TypeInt:
            case SpirVOp.TypeFloat:
                return (int)definition[1] / 8;
            case SpirVOp.TypeVector:
                return (int)definition[2] * Size(definition[1], constant, rowMajor);
            case SpirVOp.TypeMatrix:
                (int lines, int stride) = MatrixLines(definition, constant, rowMajor);
                return (lines - 1) * stride + LineSize(definition, rowMajor);
            case SpirVOp.TypeArray:
                int element = Size(definition[1], constant, rowMajor);
                int step = Round(element, constant ? Row : Alignment(definition[1]));
                SetStride(type, constant, step);
                return ((int)index.ArrayLength(definition) - 1) * step + element;
            case SpirVOp.TypeRuntimeArray:
                SetStride(type, constant, Size(definition[1], constant, rowMajor));
                return 0;
            case SpirVOp.TypeStruct:
                return Place(definition, constant);
            default:
                throw new InvalidDataException($"SPIR-V type with opcode {definition.Op} in a buffer");
        }
    }

    private int Place(SpirVInstruction structure, bool constant)
    {
        uint type = structure[0];
        Claim(type, constant);
        int end = 0;
        int alignment = 4;
        for (int member = 0; member < structure.Operands.Length - 1; member++)
        {
            uint memberType = structure[member + 1];
            bool rowMajor = index.Find(type, member, SpirVDecoration.ColMajor) is null;
            int size = Size(memberType, constant, rowMajor);
            int own = Alignment(memberType);
            alignment = Math.Max(alignment, own);
            int offset = Round(end, own);
            if (constant && (StartsRow(memberType) || offset / Row != (offset + Math.Max(size, 1) - 1) / Row))
            {
                offset = Round(offset, Row);
            }
            if (_writing)
            {
                SetMember(type, member, offset, constant, rowMajor);
            }
            end = offset + size;
        }
        return constant ? end : Round(end, alignment);
    }

    private void SetMember(uint type, int member, int offset, bool constant, bool rowMajor)
    {
        index.Set(type, member, SpirVDecoration.Offset, (uint)offset);
        if (Matrix(index.Definition(type)[member + 1]) is { } matrix)
        {
            index.Set(type, member, SpirVDecoration.MatrixStride, (uint)MatrixLines(matrix, constant, rowMajor).Stride);
        }
    }

    private void SetStride(uint array, bool constant, int stride)
    {
        if (!_writing)
        {
            return;
        }
        Claim(array, constant);
        if (index.Definition(array).Op == SpirVOp.TypeRuntimeArray && index.Find(array, SpirVDecoration.ArrayStride)?[2] != (uint)stride)
        {
            ChangedStrides.Add(array);
        }
        index.Set(array, SpirVDecoration.ArrayStride, (uint)stride);
    }

    private void Claim(uint type, bool constant)
    {
        if (_writing && _rules.TryGetValue(type, out bool before) && before != constant)
        {
            throw new InvalidDataException($"SPIR-V type '{index.Name(type)}' serves a constant and a structured buffer");
        }
        _rules[type] = constant;
    }

    private bool StartsRow(uint type) =>
        index.Definition(type).Op is SpirVOp.TypeArray or SpirVOp.TypeMatrix or SpirVOp.TypeStruct;

    /// <summary>4 bytes, or 8 for anything that holds a 64-bit number.</summary>
    private int Alignment(uint type)
    {
        SpirVInstruction definition = index.Definition(type);
        return definition.Op switch
        {
            SpirVOp.TypeInt or SpirVOp.TypeFloat => Math.Max(4, (int)definition[1] / 8),
            SpirVOp.TypeVector or SpirVOp.TypeMatrix or SpirVOp.TypeArray or SpirVOp.TypeRuntimeArray => Alignment(definition[1]),
            SpirVOp.TypeStruct => definition.Operands.Skip(1).Select(Alignment).DefaultIfEmpty(4).Max(),
            _ => 4,
        };
    }

    private SpirVInstruction? Matrix(uint type)
    {
        SpirVInstruction definition = index.Definition(type);
        return definition.Op switch
        {
            SpirVOp.TypeMatrix => definition,
            SpirVOp.TypeArray or SpirVOp.TypeRuntimeArray => Matrix(definition[1]),
            _ => null,
        };
    }

    private (int Lines, int Stride) MatrixLines(SpirVInstruction matrix, bool constant, bool rowMajor)
    {
        int line = LineSize(matrix, rowMajor);
        int columnLength = (int)index.Definition(matrix[1])[2];
        return (rowMajor ? columnLength : (int)matrix[2], constant ? Round(line, Row) : line);
    }

    private int LineSize(SpirVInstruction matrix, bool rowMajor)
    {
        SpirVInstruction column = index.Definition(matrix[1]);
        if (matrix[2] < 2 || column.Op != SpirVOp.TypeVector)
        {
            throw new InvalidDataException("a matrix of one row or column has no SPIR-V form; declare it as a vector");
        }
        int scalar = (int)index.Definition(column[1])[1] / 8;
        return scalar * (int)(rowMajor ? matrix[2] : column[2]);
    }

    private static int Round(int value, int step) => (value + step - 1) / step * step;
}
