namespace Headless.Checks;

/// <summary>What a check found: one line of figures, and the findings that make it fail.</summary>
internal sealed class CheckReport(string name)
{
    public string Name { get; } = name;
    public string Figures { get; set; } = "";
    public List<string> Findings { get; } = [];
    public string? SkippedBecause { get; set; }
    public bool Passed => Findings.Count == 0 && SkippedBecause is null;

    public void Print()
    {
        var verdict = SkippedBecause is not null ? "skipped" : Passed ? "passed" : "FAILED";
        Console.WriteLine($"{verdict,-8} {Name}: {(SkippedBecause ?? Figures)}");
        foreach (var finding in Findings.Take(40)) Console.WriteLine($"         {finding}");
        if (Findings.Count > 40) Console.WriteLine($"         ... and {Findings.Count - 40} more");
    }
}
