using System.Globalization;
using Headless.Files;

namespace Headless.Shaders;

/// <summary>Walks the tokens of a .shader file.</summary>
internal sealed class ShaderLabReader(string file, List<ShaderLabToken> tokens)
{
    private int _at;

    public string File { get; } = file;

    public ShaderLabToken Peek => tokens[_at];

    public ShaderLabToken Next() => Peek.Kind == ShaderLabTokenKind.End ? throw Unexpected("more") : tokens[_at++];

    public bool TryTake(string symbol)
    {
        if (!Peek.Is(symbol))
        {
            return false;
        }
        _at++;
        return true;
    }

    public void Expect(string symbol)
    {
        if (!TryTake(symbol))
        {
            throw Unexpected($"'{symbol}'");
        }
    }

    public string Word(string what) => Peek.Kind == ShaderLabTokenKind.Word ? Next().Text : throw Unexpected(what);

    public string Text(string what) => Peek.Kind == ShaderLabTokenKind.Text ? Next().Text : throw Unexpected(what);

    public float Number() => TryNumber(Peek, out float value) ? Take(value) : throw Unexpected("a number");

    public int Integer()
    {
        float value = Number();
        return value == MathF.Truncate(value) ? (int)value : throw Error(tokens[_at - 1].Line, $"'{value}' is no whole number");
    }

    public static bool TryNumber(ShaderLabToken token, out float value)
    {
        value = 0;
        return token.Kind == ShaderLabTokenKind.Word
            && float.TryParse(token.Text, NumberStyles.Float, CultureInfo.InvariantCulture, out value);
    }

    /// <summary>Skips a { } block whose opening brace comes next.</summary>
    public void SkipBlock()
    {
        Expect("{");
        for (int depth = 1; depth > 0;)
        {
            ShaderLabToken token = Next();
            depth += token.Is("{") ? 1 : token.Is("}") ? -1 : 0;
        }
    }

    public ShaderCompileException Unexpected(string requested) =>
        Error(Peek.Line, $"unexpected '{OneLine.Value(Describe(Peek))}', expected {requested}");

    public ShaderCompileException Error(int line, string message) => new(File, line, message);

    private static string Describe(ShaderLabToken token) =>
        token.Kind == ShaderLabTokenKind.Program ? token.Keyword : token.Text;

    private float Take(float value)
    {
        _at++;
        return value;
    }
}
