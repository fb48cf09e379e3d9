namespace Headless.Shaders;

/// <summary>One run of the compiler.</summary>
/// <param name="Text">Whole HLSL text of the stage.</param>
/// <param name="Owner">What is compiled, for messages: "kernel 'CSMain'", "pass 'FORWARD' of 'Standard', vertex stage 'vert'".</param>
internal sealed record StageJob(ExpandedSource Source, ShaderStage Stage, string EntryPoint, string Text, string Owner)
{
    /// <summary>Name of the entry point's function in Text, where it is another one.</summary>
    public string SourceEntryPoint { get; init; } = EntryPoint;

    /// <summary>Makes the text as it is written, without FXC's rules.</summary>
    public Func<string>? Plain { get; init; }

    /// <summary>Text that declarations are read from: that behind the preprocessor, where what is read may hang on macros.</summary>
    public string Declarations { get; init; } = Text;
}
