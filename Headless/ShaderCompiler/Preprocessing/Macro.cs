namespace Headless.Shaders.Preprocessing;

/// <summary>What is known of a name at a place of the text.</summary>
/// <param name="Defined">Null where that depends on the variant.</param>
/// <param name="Body">Null where nothing is defined, or what is defined depends on the variant.</param>
internal sealed record Macro(bool? Defined, MacroBody? Body)
{
    public static readonly Macro Undefined = new(false, null);
    public static readonly Macro Varies = new(null, null);

    /// <summary>Defined as something that depends on the variant.</summary>
    public static readonly Macro DefinedSomehow = new(true, null);

    /// <summary>What is known where either of two branches was taken.</summary>
    public static Macro Either(Macro a, Macro b)
    {
        if (a.Equals(b)) return a;
        return a.Defined is true && b.Defined is true ? DefinedSomehow : Varies;
    }

    /// <summary>Reads what follows #define: <c>NAME value</c> or <c>NAME(a, b) value</c>; null where it is malformed.</summary>
    public static (string Name, Macro Macro)? Read(string definition)
    {
        string text = definition.Trim();
        int end = 0;
        while (end < text.Length && (char.IsLetterOrDigit(text[end]) || text[end] == '_')) end++;
        if (end == 0) return null;
        string name = text[..end];
        if (end == text.Length || text[end] != '(') return (name, new Macro(true, new MacroBody(null, text[end..].Trim())));
        int close = text.IndexOf(')', end);
        if (close < 0) return null;
        string[] parameters = text[(end + 1)..close].Split(',', StringSplitOptions.TrimEntries | StringSplitOptions.RemoveEmptyEntries);
        return (name, new Macro(true, new MacroBody(string.Join(',', parameters), text[(close + 1)..].Trim())));
    }
}
