using System.Text.RegularExpressions;

namespace Headless.Checks.Documents.Facts;

/// <summary>How many there are of what the packages hold: <c>count:cases</c>, and in words <c>count:cases:word</c>.</summary>
internal sealed partial class CountFacts(ProjectPackages packages, Lazy<CodeFacts> code)
{
    private static readonly string[] words =
        ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve", "thirteen", "fourteen", "fifteen", "sixteen", "seventeen", "eighteen", "nineteen", "twenty"];

    /// <summary>What documents call these things, to find a number that is typed.</summary>
    public static IReadOnlyDictionary<string, string> Names { get; } = new Dictionary<string, string>
    {
        ["cases"] = "test cases|cases with a known answer|flows with a known answer",
        ["kernels"] = "kernels of the packages?|compute kernels",
        ["samples"] = "samples of the (?:product|package)|sample scenes",
        ["liquids"] = "liquids in one click|liquids come with",
        ["parameters"] = "fields of (?:a|the) profile",
        ["entries"] = "entry points",
        ["methods"] = "simulation methods",
    };

    public string Find(string[] name)
    {
        if (name.Length == 0) throw new UnknownFactException("what is counted");
        var count = Count(name[0]);
        if (name.Length == 1) return FactText.Number(count);
        var word = count < words.Length ? words[count] : FactText.Number(count);
        return name[1] switch
        {
            "word" => word,
            "Word" => char.ToUpperInvariant(word[0]) + word[1..],
            _ => throw new UnknownFactException($"'{name[1]}' is neither word nor Word"),
        };
    }

    private int Count(string name) => name switch
    {
        "cases" => Catalogue().Count(File.ReadAllText(packages.Files().First(f => Path.GetFileName(f) == "CaseCatalogue.cs"))),
        "flows" => Count("cases") - Count("gates"),
        "gates" => Gate().Count(string.Concat(packages.Files().Where(f => f.EndsWith("Case.cs", StringComparison.Ordinal)).Select(File.ReadAllText))),
        "kernels" => Shipped(".compute").Sum(f => Kernel().Count(File.ReadAllText(f))),
        "entries" => Shipped(".compute").Sum(f => Kernel().Count(File.ReadAllText(f))) + Shipped(".shader").Sum(f => Stage().Count(File.ReadAllText(f))),
        "samples" => Directory.GetFiles(Path.Combine(packages.Product, "Samples~"), "*.unity", SearchOption.AllDirectories).Length,
        "liquids" => packages.Files().Count(f => f.EndsWith(".asset", StringComparison.Ordinal) && Path.GetFileName(Path.GetDirectoryName(f)) == "Liquids"),
        "parameters" => code.Value.ShownFields("FluidProfile"),
        "methods" => Directory.GetFiles(packages.Product, "*Method.cs", SearchOption.AllDirectories).Count(f => Method().IsMatch(File.ReadAllText(f))),
        _ => throw new UnknownFactException($"'{name}' is none of what is counted"),
    };

    private IEnumerable<string> Shipped(string ending) =>
        packages.Files().Where(f => f.EndsWith(ending, StringComparison.Ordinal) && !("/" + packages.PathInPackage(f)).Contains("/Tests/", StringComparison.Ordinal));

    [GeneratedRegex(@"new \w+Case\(\)")] private static partial Regex Catalogue();
    [GeneratedRegex(@"IsGate => true")] private static partial Regex Gate();
    [GeneratedRegex(@"^\s*#pragma kernel \w", RegexOptions.Multiline)] private static partial Regex Kernel();
    [GeneratedRegex(@"^\s*#pragma (?:vertex|fragment|geometry) \w", RegexOptions.Multiline)] private static partial Regex Stage();
    [GeneratedRegex(@"class \w+ : FluidMethod\b")] private static partial Regex Method();
}
