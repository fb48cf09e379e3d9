using System.Globalization;

namespace Headless.Bench.Scene;

/// <summary>A span of simulated time that gets a row.</summary>
internal sealed record ScenePhase(double From, double To)
{
    public string Name => string.Create(CultureInfo.InvariantCulture, $"{From:0.###}-{To:0.###}");

    /// <summary>Whether a frame that ends at this time belongs to it: of 0-1 at 30 frames a second frames 1 to 30.</summary>
    public bool Has(int frame, double fps) => frame > From * fps + 1e-6 && frame <= To * fps + 1e-6;

    /// <summary>"0-1,4-5".</summary>
    public static ScenePhase[] ParseList(string flag, string text)
    {
        var phases = new List<ScenePhase>();
        foreach (string word in text.Split(','))
        {
            string[] ends = word.Split('-');
            bool good = ends.Length == 2 & Seconds(ends[0], out double from) & Seconds(ends[^1], out double to) && to > from;
            if (!good || phases.Count > 0 && from < phases[^1].To)
                throw new UsageException($"{flag} must be spans of seconds in rising order, as 0-1,4-5; found '{text}'.");
            phases.Add(new ScenePhase(from, to));
        }
        return [.. phases];
    }

    private static bool Seconds(string text, out double value) =>
        double.TryParse(text, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out value) && value <= 86400;
}
