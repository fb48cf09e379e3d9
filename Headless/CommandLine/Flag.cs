namespace Headless.CommandLine;

/// <summary>A flag of a command. The parser and the help both read it, so that neither has a flag that the other lacks.</summary>
/// <param name="Name">As <c>--size</c>.</param>
/// <param name="Value">What stands for its value in the help, as <c>WxH</c>; null for a switch.</param>
/// <param name="Text">What it does, in a few words.</param>
/// <param name="Absent">What holds without it; null where the text says it.</param>
public sealed record Flag(string Name, string? Value, string Text, string? Absent = null)
{
    /// <summary>The only values that it takes; empty for any.</summary>
    public IReadOnlyList<string> Choices { get; init; } = [];

    /// <summary>For the program that starts this one; no help of <c>./run</c> lists it.</summary>
    public bool Hidden { get; init; }

    /// <summary>Whether the words behind it up to the next flag are its values.</summary>
    public bool TakesList => Value is not null && Value.EndsWith("...", StringComparison.Ordinal);

    /// <summary>A flag without a value.</summary>
    public static Flag Switch(string name, string text) => new(name, null, text);
}
