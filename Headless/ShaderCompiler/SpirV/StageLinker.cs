namespace Headless.Shaders.SpirV;

/// <summary>Gives inputs and outputs of consecutive stages the same locations where their semantics agree.</summary>
internal static class StageLinker
{
    /// <summary>Numbers a vertex stage's attributes in their order of declaration.</summary>
    public static IReadOnlyList<VertexInput> NumberVertexInputs(SpirVIndex vertex)
    {
        List<VertexInput> inputs = [];
        int location = 0;
        foreach (StageVariable input in StageInterface.Read(vertex, SpirVStorage.Input, perVertex: false))
        {
            vertex.Set(input.Id, SpirVDecoration.Location, (uint)location);
            if (input.Locations != 1)
            {
                throw new InvalidDataException($"vertex input {input.Semantic} is an array or matrix; declare its rows one by one");
            }
            inputs.Add(new VertexInput(input.Semantic, location, input.Components, input.Scalar != "float"));
            location++;
        }
        return inputs;
    }

    /// <summary>Gives SV_TargetN, or COLORN as Direct3D 9 had it, location N.</summary>
    public static void NumberTargets(SpirVIndex fragment)
    {
        foreach (StageVariable output in StageInterface.Read(fragment, SpirVStorage.Output, perVertex: false))
        {
            string? number = TargetNumber(output.Semantic, "SV_TARGET") ?? TargetNumber(output.Semantic, "COLOR");
            if (number is null)
            {
                throw new InvalidDataException($"fragment output has semantic {output.Semantic}; write SV_Target or SV_Depth");
            }
            fragment.Set(output.Id, SpirVDecoration.Location, number.Length == 0 ? 0 : uint.Parse(number));
        }
    }

    /// <exception cref="InvalidDataException">The later stage reads what the earlier one does not write.</exception>
    public static void Link(SpirVIndex earlier, ShaderStage earlierStage, SpirVIndex later, ShaderStage laterStage)
    {
        LegacyPosition.Replace(earlier, later, laterStage);
        Dictionary<string, (StageVariable Output, int Location)> outputs = [];
        int location = 0;
        foreach (StageVariable output in StageInterface.Read(earlier, SpirVStorage.Output, perVertex: false))
        {
            if (!outputs.TryAdd(output.Semantic, (output, location)))
            {
                throw new InvalidDataException($"{earlierStage} stage writes semantic {output.Semantic} twice");
            }
            earlier.Set(output.Id, SpirVDecoration.Location, (uint)location);
            location += output.Locations;
        }
        foreach (StageVariable input in StageInterface.Read(later, SpirVStorage.Input, laterStage == ShaderStage.Geometry))
        {
            if (!outputs.TryGetValue(input.Semantic, out (StageVariable Output, int Location) source))
            {
                throw new InvalidDataException(
                    $"{laterStage} stage reads semantic {input.Semantic}, which the {earlierStage} stage does not write");
            }
            if (source.Output.Scalar != input.Scalar || source.Output.Components < input.Components
                || source.Output.Locations < input.Locations)
            {
                throw new InvalidDataException(
                    $"semantic {input.Semantic} is {Describe(source.Output)} in the {earlierStage} stage but {Describe(input)} in the "
                    + $"{laterStage} stage");
            }
            later.Set(input.Id, SpirVDecoration.Location, (uint)source.Location);
            if (laterStage == ShaderStage.Fragment && input.Scalar != "float")
            {
                later.SetFlag(input.Id, SpirVDecoration.Flat);
            }
        }
    }

    private static string? TargetNumber(string semantic, string name) =>
        semantic.StartsWith(name, StringComparison.Ordinal) ? semantic[name.Length..] : null;

    private static string Describe(StageVariable v) =>
        v.Scalar + (v.Components > 1 ? v.Components : "") + (v.Rows > 1 ? "x" + v.Rows : "") + (v.Elements > 1 ? $"[{v.Elements}]" : "");
}
