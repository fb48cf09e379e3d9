namespace Headless.Shaders.SpirV;

/// <summary>Takes the output semantic POSITION of Direct3D 9 for SV_Position, as FXC's compatibility mode does.</summary>
internal static class LegacyPosition
{
    private const uint Position = 0;
    private const uint FragmentCoordinates = 15;

    public static void Replace(SpirVIndex earlier, SpirVIndex later, ShaderStage laterStage)
    {
        StageVariable? output = Find(earlier, SpirVStorage.Output, perVertex: false);
        if (output is null)
        {
            return;
        }
        earlier.Replace(output.Id, SpirVDecoration.Location, SpirVDecoration.BuiltIn, Position);
        if (Find(later, SpirVStorage.Input, laterStage == ShaderStage.Geometry) is { } input)
        {
            uint builtIn = laterStage == ShaderStage.Fragment ? FragmentCoordinates : Position;
            later.Replace(input.Id, SpirVDecoration.Location, SpirVDecoration.BuiltIn, builtIn);
        }
    }

    private static StageVariable? Find(SpirVIndex index, SpirVStorage storage, bool perVertex) =>
        StageInterface.Read(index, storage, perVertex).Find(v => v.Semantic == "POSITION");
}
