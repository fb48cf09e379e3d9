namespace Headless.Checks.Gpu;

/// <summary>When a figure counts as worse than the one in the table.</summary>
/// <param name="Fails">Whether that fails the check; otherwise it is a note.</param>
/// <param name="Percent">By how much a figure must change to count.</param>
/// <param name="MoreIsBetter">Whether a fall counts, and not a rise.</param>
internal sealed record FigureRule(string Column, bool Fails, int Percent = 0, bool MoreIsBetter = false)
{
    /// <summary>Worse by 5 %: more than 105 for 100; where more is better, less than 95.</summary>
    public bool IsWorse(int was, int now) => MoreIsBetter
        ? now * 100L < was * (100L - Percent)
        : now * 100L > was * (100L + Percent);
}
