namespace Headless.Shaders.SpirV;

/// <summary>Lists the members of a constant buffer at the offsets that stand in the module.</summary>
/// <param name="readMembers">Of the outermost structure, those that the shader reads.</param>
internal sealed class ConstantMembers(SpirVIndex index, D3DLayout layout, IReadOnlySet<uint> readMembers)
{
    private readonly List<ConstantMember> _members = [];
    private bool _isRead;

    public IReadOnlyList<ConstantMember> Read(uint structure)
    {
        Walk(structure, "", 0);
        return _members;
    }

    private void Walk(uint structure, string path, int start)
    {
        SpirVInstruction definition = index.Definition(structure);
        for (int member = 0; member < definition.Operands.Length - 1; member++)
        {
            _isRead = path.Length > 0 ? _isRead : readMembers.Contains((uint)member);
            string name = path + index.MemberName(structure, member);
            int offset = start + (int)index.Find(structure, member, SpirVDecoration.Offset)![3];
            bool rowMajor = index.Find(structure, member, SpirVDecoration.ColMajor) is null;
            Member(definition[member + 1], name, offset, rowMajor);
        }
    }

    private void Member(uint type, string name, int offset, bool rowMajor)
    {
        SpirVInstruction definition = index.Definition(type);
        int length = 0;
        int stride = 0;
        if (definition.Op == SpirVOp.TypeArray)
        {
            length = (int)index.ArrayLength(definition);
            stride = (int)index.Find(type, SpirVDecoration.ArrayStride)![2];
            SpirVInstruction element = index.Definition(definition[1]);
            if (element.Op is SpirVOp.TypeStruct or SpirVOp.TypeArray)
            {
                for (int i = 0; i < length; i++)
                {
                    Member(definition[1], $"{name}[{i}]", offset + i * stride, rowMajor);
                }
                return;
            }
            type = definition[1];
            definition = element;
        }
        if (definition.Op == SpirVOp.TypeStruct)
        {
            Walk(type, name + ".", offset);
            return;
        }
        int size = layout.Size(type, constant: true, rowMajor) + Math.Max(0, length - 1) * stride;
        (string scalar, int rows, int columns) = Shape(definition);
        bool matrix = definition.Op == SpirVOp.TypeMatrix;
        _members.Add(new ConstantMember(name, offset, size, length, stride, scalar, matrix, rows, columns)
        {
            RowMajor = matrix && !rowMajor,
            IsRead = _isRead,
        });
    }

    // HLSL's rows and columns; a vector is one row.
    private (string Scalar, int Rows, int Columns) Shape(SpirVInstruction type)
    {
        switch (type.Op)
        {
            case SpirVOp.TypeMatrix:
                (string element, _, int columns) = Shape(index.Definition(type[1]));
                return (element, (int)type[2], columns);
            case SpirVOp.TypeVector:
                return (Shape(index.Definition(type[1])).Scalar, 1, (int)type[2]);
            case SpirVOp.TypeFloat:
                return (type[1] == 64 ? "double" : "float", 1, 1);
            default:
                return (type.Operands.Length > 2 && type[2] == 1 ? "int" : "uint", 1, 1);
        }
    }
}
