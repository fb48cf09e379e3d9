namespace Headless.Bench.Scene;

/// <summary>How many times as long the other build took: of the sums, and the middle and quarters of the pairs of frames.</summary>
internal readonly record struct Ratio(double OfSums, double Median, double Low, double High)
{
    public static Ratio None => new(double.NaN, double.NaN, double.NaN, double.NaN);

    /// <summary>Of pairs of times; pairs in which this build took none are left out of the median.</summary>
    public static Ratio Of(IReadOnlyList<(double This, double Other)> pairs)
    {
        double[] ratios = [.. pairs.Where(p => p.This > 0).Select(p => p.Other / p.This).Order()];
        double sum = pairs.Sum(p => p.Other) / pairs.Sum(p => p.This);
        return ratios.Length == 0 ? new Ratio(sum, double.NaN, double.NaN, double.NaN) : new Ratio(sum, At(ratios, 0.5), At(ratios, 0.25), At(ratios, 0.75));
    }

    /// <summary>Quantile of sorted numbers, linear between two of them.</summary>
    internal static double At(double[] sorted, double share)
    {
        double place = share * (sorted.Length - 1);
        int below = (int)place;
        return below + 1 < sorted.Length ? sorted[below] + (place - below) * (sorted[below + 1] - sorted[below]) : sorted[^1];
    }
}
