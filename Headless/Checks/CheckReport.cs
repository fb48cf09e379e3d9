namespace Headless.Checks;

/// <summary>What a check found: one line of figures, the findings that make it fail, and notes that do not.</summary>
internal sealed class CheckReport(string name)
{
    private const int MaxPrinted = 40;

    public string Name { get; } = name;
    public string Figures { get; set; } = "";
    public List<string> Findings { get; } = [];
    public List<string> Notes { get; } = [];
    public string? SkippedBecause { get; set; }
    public bool Passed => Findings.Count == 0 && SkippedBecause is null;

    public void Print()
    {
        var verdict = SkippedBecause is not null ? "skipped" : Passed ? "passed" : "FAILED";
        Console.WriteLine($"{verdict,-8} {Name}: {(SkippedBecause ?? Figures)}");
        PrintAll(Findings, "");
        PrintAll(Notes, "note: ");
    }

    private static void PrintAll(List<string> texts, string start)
    {
        foreach (var text in texts.Take(MaxPrinted)) Console.WriteLine($"         {start}{text}");
        if (texts.Count > MaxPrinted) Console.WriteLine($"         {start}... and {texts.Count - MaxPrinted} more");
    }
}
