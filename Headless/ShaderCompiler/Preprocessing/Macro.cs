namespace Headless.Shaders.Preprocessing;

/// <summary>What a name stands for.</summary>
/// <param name="Body">Null where it cannot be told, or nothing is defined.</param>
internal sealed record Macro(bool Defined, MacroBody? Body)
{
    public static readonly Macro Undefined = new(false, null);
    public static readonly Macro Somehow = new(true, null);

    public static Macro Of(string value) => new(true, new MacroBody(null, value));

    /// <summary>Reads what follows #define: <c>NAME value</c> or <c>NAME(a, b) value</c>; null where it is malformed.</summary>
    public static (string Name, Macro Macro)? Read(string definition)
    {
        string text = definition.Trim();
        int end = 0;
        while (end < text.Length && (char.IsLetterOrDigit(text[end]) || text[end] == '_')) end++;
        if (end == 0) return null;
        string name = text[..end];
        if (end == text.Length || text[end] != '(') return (name, Of(text[end..].Trim()));
        int close = text.IndexOf(')', end);
        if (close < 0) return null;
        string[] parameters = text[(end + 1)..close].Split(',', StringSplitOptions.TrimEntries | StringSplitOptions.RemoveEmptyEntries);
        return (name, new Macro(true, new MacroBody(string.Join(',', parameters), text[(close + 1)..].Trim())));
    }
}
