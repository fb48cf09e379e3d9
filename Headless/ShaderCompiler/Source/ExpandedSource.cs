namespace Headless.Shaders;

/// <summary>HLSL with its includes in place.</summary>
/// <param name="Text">Carries "#line line file" directives; file is an index into Files, counted from 1.</param>
/// <param name="Files">Paths for messages.</param>
/// <param name="Messages">Texts of #error directives: in Text stands "#error HEADLESS_MESSAGE_n", n an index into them.</param>
/// <param name="Pragmas">Unity's pragmas of the main file and of #include_with_pragmas files; blank in Text.</param>
internal sealed record ExpandedSource(string Text, IReadOnlyList<string> Files, IReadOnlyList<string> Messages, IReadOnlyList<PragmaLine> Pragmas)
{
    /// <summary>Stands for a text, whose quotes and spaces would not survive the compiler.</summary>
    public const string MessageWord = "HEADLESS_MESSAGE_";

    private string? _hlsl;
    private string[]? _branchKeywords;

    /// <summary>Keywords of dynamic_branch pragmas.</summary>
    public IReadOnlyList<string> BranchKeywords => _branchKeywords ??=
        [.. Pragmas.SelectMany(p => KeywordPragmas.Read(p) ?? []).Where(s => s.Branch).SelectMany(s => s.Keywords).Where(k => k.Length > 0).Distinct()];

    /// <summary>Text with FXC's rules for globals and loop variables written out.</summary>
    public string Hlsl => _hlsl ??= FxcRules.WriteDeclarations(Text);

    public string FileName(int index) => index >= 1 && index <= Files.Count ? Files[index - 1] : Files[0];
}
