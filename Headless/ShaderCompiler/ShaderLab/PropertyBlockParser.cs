namespace Headless.Shaders;

/// <summary>Reads Properties { [Attribute] _Name ("Display", Type) = value ... }.</summary>
internal static class PropertyBlockParser
{
    private static readonly Dictionary<string, ShaderPropertyType> Types = new(StringComparer.OrdinalIgnoreCase)
    {
        ["Float"] = ShaderPropertyType.Float,
        ["Int"] = ShaderPropertyType.Float,
        ["Range"] = ShaderPropertyType.Range,
        ["Integer"] = ShaderPropertyType.Integer,
        ["Color"] = ShaderPropertyType.Color,
        ["Vector"] = ShaderPropertyType.Vector,
        ["2D"] = ShaderPropertyType.Texture2D,
        ["Rect"] = ShaderPropertyType.Texture2D,
        ["Any"] = ShaderPropertyType.Texture2D,
        ["3D"] = ShaderPropertyType.Texture3D,
        ["Cube"] = ShaderPropertyType.TextureCube,
        ["2DArray"] = ShaderPropertyType.Texture2DArray,
        ["CubeArray"] = ShaderPropertyType.TextureCubeArray,
    };

    public static List<ShaderProperty> Read(ShaderLabReader reader)
    {
        List<ShaderProperty> properties = [];
        HashSet<string> names = [];
        reader.Expect("{");
        while (!reader.TryTake("}"))
        {
            int line = reader.Peek.Line;
            ShaderProperty property = Property(reader);
            if (!names.Add(property.Name))
            {
                throw reader.Error(line, $"property '{property.Name}' is declared twice");
            }
            properties.Add(property);
        }
        return properties;
    }

    private static ShaderProperty Property(ShaderLabReader reader)
    {
        List<string> attributes = [];
        while (reader.TryTake("["))
        {
            attributes.Add(Attribute(reader));
        }
        string name = reader.Word("a property name");
        reader.Expect("(");
        string display = reader.Text("the display name in quotes");
        reader.Expect(",");
        ShaderLabToken typeToken = reader.Next();
        if (!Types.TryGetValue(typeToken.Text, out ShaderPropertyType type))
        {
            throw reader.Error(typeToken.Line, $"unknown property type '{typeToken.Text}' of '{name}'");
        }
        float minimum = 0;
        float maximum = 0;
        if (type == ShaderPropertyType.Range)
        {
            reader.Expect("(");
            minimum = reader.Number();
            reader.Expect(",");
            maximum = reader.Number();
            reader.Expect(")");
        }
        reader.Expect(")");
        reader.Expect("=");
        (float[] value, string texture) = Default(reader, type);
        return new ShaderProperty(name, display, type, value, texture, attributes) { RangeMin = minimum, RangeMax = maximum };
    }

    private static string Attribute(ShaderLabReader reader)
    {
        string text = reader.Word("an attribute name");
        if (reader.TryTake("("))
        {
            List<string> arguments = [];
            while (!reader.TryTake(")"))
            {
                string argument = reader.Next().Text;
                if (argument != ",")
                {
                    arguments.Add(argument);
                }
            }
            text += $"({string.Join(", ", arguments)})";
        }
        reader.Expect("]");
        return text;
    }

    private static (float[] Value, string Texture) Default(ShaderLabReader reader, ShaderPropertyType type)
    {
        switch (type)
        {
            case ShaderPropertyType.Float:
            case ShaderPropertyType.Range:
            case ShaderPropertyType.Integer:
                return ([reader.Number(), 0, 0, 0], "");
            case ShaderPropertyType.Color:
            case ShaderPropertyType.Vector:
                return (Tuple(reader, type), "");
            default:
                string texture = reader.Text("the default texture in quotes");
                if (reader.Peek.Is("{"))
                {
                    reader.SkipBlock();
                }
                return ([0, 0, 0, 0], texture);
        }
    }

    // (1, 0.5, 0) leaves w at 1 for a colour and 0 for a vector.
    private static float[] Tuple(ShaderLabReader reader, ShaderPropertyType type)
    {
        int line = reader.Peek.Line;
        List<float> numbers = [];
        reader.Expect("(");
        do
        {
            numbers.Add(reader.Number());
        }
        while (reader.TryTake(","));
        reader.Expect(")");
        if (numbers.Count is not (3 or 4))
        {
            throw reader.Error(line, $"a default of {numbers.Count} numbers; expected 3 or 4");
        }
        if (numbers.Count == 3)
        {
            numbers.Add(type == ShaderPropertyType.Color ? 1 : 0);
        }
        return [.. numbers];
    }
}
