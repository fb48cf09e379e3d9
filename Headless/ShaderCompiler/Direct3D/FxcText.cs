using System.Text.RegularExpressions;

namespace Headless.Shaders.Direct3D;

/// <summary>Puts a stage's text in the form that FXC takes.</summary>
internal static partial class FxcText
{
    /// <summary>FXC takes a file name after #line where glslang takes a number.</summary>
    public static string From(string text, ExpandedSource source) => LineDirective().Replace(
        text, m => $"#line {m.Groups[1].Value} \"{source.FileName(int.Parse(m.Groups[2].Value)).Replace('\\', '/')}\"");

    [GeneratedRegex(@"^#line (\d+) (\d+)[ \t]*$", RegexOptions.Multiline)]
    private static partial Regex LineDirective();
}
