using System.Text.RegularExpressions;

namespace Headless.Checks.Documents.Facts;

/// <summary>
/// Something that one method or another can do: its name in <c>FluidMethodFeatures</c>, what documents call it, and what they say when they mean it. Without a name, something that the package has whatever
/// the method.
/// </summary>
internal sealed record Capability(string Feature, string Label, Regex Words)
{
    /// <summary>Whether it does not depend on the method.</summary>
    public bool IsOfAll => Feature.Length == 0;

    /// <summary>Those of Data/capabilities.csv. What is without a label is of no interest to users.</summary>
    public static IReadOnlyList<Capability> Read(string project) =>
        [.. CsvTable.Read(Path.Combine(project, "Headless", "Checks", "Documents", "Facts", "Data", "capabilities.csv")).Rows
            .Select(r => new Capability(r["feature"], r["label"], new Regex(r["words"].Length > 0 ? $@"\b(?:{r["words"]})\b" : "(?!)", RegexOptions.CultureInvariant)))];
}
