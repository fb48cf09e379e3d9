using System.Globalization;

namespace Headless.Importers.Yaml;

/// <summary>Where a value was read: <c>Assets/A.unity:12</c>. Values that no file holds have no place.</summary>
public readonly record struct YamlPlace(string File, int Line)
{
    public override string ToString() =>
        Line > 0 ? string.Create(CultureInfo.InvariantCulture, $"{File}:{Line}") : File ?? "";
}
