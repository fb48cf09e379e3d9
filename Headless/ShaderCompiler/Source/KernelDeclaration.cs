namespace Headless.Shaders;

/// <param name="Defines">Macros of this kernel in order: name and value ("1" where none is written).</param>
/// <param name="Line">Line of the pragma, 1-based.</param>
public sealed record KernelDeclaration(string Name, IReadOnlyList<KeyValuePair<string, string>> Defines, int Line);
