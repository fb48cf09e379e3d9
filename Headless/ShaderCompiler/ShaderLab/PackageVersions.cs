namespace Headless.Shaders;

/// <summary>Decides PackageRequirements.</summary>
internal static class PackageVersions
{
    /// <summary>Version that "unity" is compared with.</summary>
    private const string Unity = "2022.3.0";

    /// <param name="required">
    /// "1.2.3" (this or later), an interval such as "[1.0,2.0)", or "" for any; as in version defines.
    /// </param>
    public static bool Met(PackageFolders packages, string name, string required)
    {
        string? version = string.Equals(name, "unity", StringComparison.OrdinalIgnoreCase) ? Unity : packages.Find(name)?.Version;
        return version is not null && Contains(required, version);
    }

    public static bool Contains(string range, string version)
    {
        string text = range.Trim();
        if (text.Length == 0)
        {
            return true;
        }
        if (text[0] is not ('[' or '('))
        {
            return Compare(version, text) >= 0;
        }
        if (text.Length < 3 || text[^1] is not (']' or ')'))
        {
            return false;
        }
        string[] ends = text[1..^1].Split(',');
        if (ends.Length == 1)
        {
            return Compare(version, ends[0]) == 0;
        }
        int low = ends[0].Trim().Length == 0 ? 1 : Compare(version, ends[0]);
        int high = ends[1].Trim().Length == 0 ? -1 : Compare(version, ends[1]);
        return (low > 0 || (low == 0 && text[0] == '[')) && (high < 0 || (high == 0 && text[^1] == ']'));
    }

    // Numbers only: "6000.0.23f1" and "1.2.0-pre.3" count up to the first letter or dash of each part.
    private static int Compare(string left, string right)
    {
        int[] a = Numbers(left);
        int[] b = Numbers(right);
        for (int i = 0; i < Math.Max(a.Length, b.Length); i++)
        {
            int order = a.ElementAtOrDefault(i).CompareTo(b.ElementAtOrDefault(i));
            if (order != 0)
            {
                return order;
            }
        }
        return 0;
    }

    private static int[] Numbers(string version) =>
        [.. version.Trim().Split('-')[0].Split('.').Take(8).Select(p => int.TryParse(string.Concat(p.TakeWhile(char.IsAsciiDigit)), out int n) ? n : 0)];
}
