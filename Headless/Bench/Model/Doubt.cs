namespace Headless.Bench.Model;

/// <summary>By what factor measured times exceed estimated ones, at least and at most.</summary>
internal readonly record struct Doubt(double Low, double High)
{
    /// <summary>How far the ratio of two cards may be off, to either side: the doubt without what both share.</summary>
    public double OfRatios => Math.Sqrt(High / Low);

    public static Doubt Of(IReadOnlyCollection<double> ratios) => new(ratios.Min(), ratios.Max());
}
