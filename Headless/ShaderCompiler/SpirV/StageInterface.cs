namespace Headless.Shaders.SpirV;

/// <summary>Reads the user-defined inputs or outputs of a stage with their HLSL semantics.</summary>
internal static class StageInterface
{
    /// <param name="perVertex">Inputs of a geometry stage: the outer array runs over the primitive's vertices.</param>
    public static List<StageVariable> Read(SpirVIndex index, SpirVStorage storage, bool perVertex)
    {
        List<StageVariable> found = [];
        foreach (SpirVInstruction variable in index.Variables)
        {
            uint id = variable[1];
            if ((SpirVStorage)variable[2] != storage || index.Has(id, SpirVDecoration.BuiltIn)
                || index.Find(id, SpirVDecoration.UserSemantic) is not { } semantic)
            {
                continue;
            }
            uint type = index.Pointee(variable);
            if (perVertex)
            {
                type = index.Definition(type)[1];
            }
            int elements = 1;
            while (index.Definition(type).Op == SpirVOp.TypeArray)
            {
                elements *= (int)index.ArrayLength(index.Definition(type));
                type = index.Definition(type)[1];
            }
            (int rows, int components, string scalar) = Shape(index, type);
            found.Add(new StageVariable(id, Canonical(semantic.Text(2)), elements, rows, components, scalar));
        }
        return found;
    }

    /// <summary>"texcoord" and "TEXCOORD0" are one semantic in HLSL, as are "NORMAL" and "NORMAL0".</summary>
    public static string Canonical(string semantic)
    {
        string upper = semantic.ToUpperInvariant();
        string name = upper.TrimEnd('0', '1', '2', '3', '4', '5', '6', '7', '8', '9');
        int number = name.Length == upper.Length ? 0 : int.Parse(upper[name.Length..]);
        return number == 0 && name != "TEXCOORD" ? name : name + number;
    }

    private static (int Rows, int Components, string Scalar) Shape(SpirVIndex index, uint type)
    {
        SpirVInstruction definition = index.Definition(type);
        switch (definition.Op)
        {
            case SpirVOp.TypeMatrix:
                (_, int length, string element) = Shape(index, definition[1]);
                return ((int)definition[2], length, element);
            case SpirVOp.TypeVector:
                return (1, (int)definition[2], Shape(index, definition[1]).Scalar);
            case SpirVOp.TypeFloat:
                return (1, 1, "float");
            case SpirVOp.TypeInt:
                return (1, 1, definition[2] == 1 ? "int" : "uint");
            default:
                return (1, 1, "bool");
        }
    }
}
