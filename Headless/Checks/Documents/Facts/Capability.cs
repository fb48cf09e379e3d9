using System.Text.RegularExpressions;

namespace Headless.Checks.Documents.Facts;

/// <summary>Something that one method or another can do: its name in <c>FluidMethodFeatures</c>, what documents call it, and what they say when they mean it.</summary>
internal sealed record Capability(string Feature, string Label, Regex Words)
{
    /// <summary>Those of Data/capabilities.csv. What is without a label is of no interest to users.</summary>
    public static IReadOnlyList<Capability> Read(string project) =>
        [.. CsvTable.Read(Path.Combine(project, "Headless", "Checks", "Documents", "Facts", "Data", "capabilities.csv")).Rows
            .Select(r => new Capability(r["feature"], r["label"], new Regex(r["words"].Length > 0 ? $@"\b(?:{r["words"]})\b" : "(?!)", RegexOptions.CultureInvariant)))];
}
