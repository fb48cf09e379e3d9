namespace Headless.Shaders.Preprocessing;

/// <param name="Parameters">Names with commas between them; null for a macro without brackets.</param>
internal sealed record MacroBody(string? Parameters, string Text)
{
    private string[]? _tokens;
    private string[]? _names;

    public string[] Tokens => _tokens ??= DirectiveTokens.Read(Text);

    public string[] ParameterNames => _names ??= (Parameters ?? "").Split(',', StringSplitOptions.RemoveEmptyEntries);

    public bool Equals(MacroBody? other) => other is not null && Parameters == other.Parameters && Text == other.Text;

    public override int GetHashCode() => HashCode.Combine(Parameters, Text);
}
