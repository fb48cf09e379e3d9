namespace Headless.Measure;

/// <summary>How long each part may take, so that all of them stay within the whole.</summary>
internal static class Budget
{
    /// <summary>What remains behind the last part [s]: to end a child that does not listen, and the page. Of the others the next ones' shares pay for that.</summary>
    public const double Reserve = 10;

    /// <summary>
    /// Seconds of the next part: its share of what is left, or the least that it needs where there is so much. What it does not take goes to the others.
    /// </summary>
    /// <param name="left">Seconds until the end of the whole.</param>
    /// <param name="weights">Weights of the part and of those behind it.</param>
    public static double Of(double left, IEnumerable<double> weights, double least)
    {
        double all = 0, first = -1;
        foreach (double weight in weights)
        {
            if (first < 0) first = weight;
            all += weight;
        }
        double most = Math.Max(0, left - Reserve);
        return all > 0 ? Math.Min(most, Math.Max(least, most * first / all)) : 0;
    }
}
