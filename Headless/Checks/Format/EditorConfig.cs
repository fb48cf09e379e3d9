using System.Globalization;
using System.Text.RegularExpressions;

namespace Headless.Checks.Format;

/// <summary>What the checks themselves take from .editorconfig.</summary>
internal static partial class EditorConfig
{
    /// <summary>Most columns of a line of code or of a shader.</summary>
    /// <exception cref="FormatException">The file does not say.</exception>
    public static int MaxLineLength(string project) =>
        MaxLineLength().Match(File.ReadAllText(Path.Combine(project, ".editorconfig"))) is { Success: true } stated
            ? int.Parse(stated.Groups[1].Value, CultureInfo.InvariantCulture)
            : throw new FormatException(".editorconfig states no max_line_length");

    [GeneratedRegex(@"^max_line_length = (\d+)$", RegexOptions.Multiline)] private static partial Regex MaxLineLength();
}
