using System.Globalization;
using System.Text.RegularExpressions;

namespace Headless.Checks.Documents.Facts;

/// <summary>A number of an asset that a package brings along: <c>asset:WaterProfile:restDensity</c>; with <c>:e</c> behind it as 1·10⁻⁶.</summary>
internal sealed class AssetFacts(ProjectPackages packages)
{
    public string Find(string[] words)
    {
        if (words.Length < 2) throw new UnknownFactException("an asset and a field");
        var files = packages.Files().Where(f => Path.GetFileName(f) == words[0] + ".asset").ToList();
        if (files.Count != 1) throw new UnknownFactException($"there are {files.Count} assets '{words[0]}'");
        var line = Regex.Match(File.ReadAllText(files[0]), $@"^ +{Regex.Escape(words[1])}: (\S+)\r?$", RegexOptions.Multiline);
        if (!line.Success) throw new UnknownFactException($"{words[0]} has no field '{words[1]}'");
        if (!double.TryParse(line.Groups[1].Value, CultureInfo.InvariantCulture, out var value)) return line.Groups[1].Value;
        return words.Length > 2 && words[2] == "e" ? FactText.Scientific(value) : FactText.Number(value);
    }

    /// <summary><c>names:Liquids</c>: the assets of a folder.</summary>
    public string Names(string[] words)
    {
        string[] names = [.. packages.Files().Where(f => f.EndsWith(".asset", StringComparison.Ordinal) && words.Contains(Path.GetFileName(Path.GetDirectoryName(f)))).Select(f => Path.GetFileNameWithoutExtension(f))];
        return names.Length > 0 ? FactText.List(names) : throw new UnknownFactException($"no folder '{string.Join(':', words)}' has assets");
    }
}
