namespace Headless.Shaders;

/// <summary>Writes out for glslang what FXC takes for granted.</summary>
internal static class FxcRules
{
    /// <summary>Globals and the variables of loops.</summary>
    public static string WriteDeclarations(string text) => GlobalInitializers.Rewrite(LoopScopes.Rewrite(text));

    /// <summary>Samplers of Direct3D 9 and swizzles of matrices.</summary>
    public static string WriteCalls(string text) => MatrixSwizzles.Rewrite(LegacySamplers.Rewrite(text));

    /// <summary>
    /// All of it in the text behind the preprocessor, with what only shows there: loops and functions that macros write, and
    /// semicolons that they leave.
    /// </summary>
    public static string WriteAll(string preprocessed) =>
        WriteCalls(WriteDeclarations(HalfOverloads.Drop(StraySemicolons.Remove(preprocessed))));
}
