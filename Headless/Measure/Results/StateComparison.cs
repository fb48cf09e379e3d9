using Headless.Bench.Model;

namespace Headless.Measure.Results;

/// <summary>Particles of two runs, state by state, as <c>play --write-sequence</c> wrote them: the first, and one after each step where no frame has two.</summary>
/// <param name="States">States that both have.</param>
/// <param name="First">The first that differs, which is the number of its step; null where none does.</param>
/// <param name="Different">Particles that lie elsewhere in it.</param>
/// <param name="Largest">The largest of their distances [m].</param>
internal sealed record StateComparison(int States, int? First, int Different, int Particles, double Largest)
{
    /// <summary>Folder of the run's timings, in that of its frames.</summary>
    public const string Play = "play";

    public bool IsEqual => First is null;

    public static StateComparison Of(string folder, string other)
    {
        string[] names = Directory.Exists(other)
            ? [.. Directory.EnumerateFiles(folder, "*.ply").Select(f => Path.GetFileName(f)).Where(n => File.Exists(Path.Combine(other, n))).Order(StringComparer.Ordinal)]
            : [];
        for (int i = 0; i < names.Length; i++)
        {
            string a = Path.Combine(folder, names[i]), b = Path.Combine(other, names[i]);
            if (File.ReadAllBytes(a).AsSpan().SequenceEqual(File.ReadAllBytes(b))) continue;
            (float X, float Y, float Z)[] own = ParticleState.Read(a), theirs = ParticleState.Read(b);
            double[] distances = [.. own.Zip(theirs, Distance)];
            return new StateComparison(names.Length, i, distances.Count(d => d > 0) + Math.Abs(own.Length - theirs.Length), own.Length, distances.Max());
        }
        return new StateComparison(names.Length, null, 0, 0, 0);
    }

    public override string ToString() => States == 0 ? "none is there to compare with"
        : First is not { } step ? $"equal to the bit in all {States - 1} steps"
        : FormattableString.Invariant(
            $"the first of {States - 1} steps that differs is step {step}: {Different} of {Particles} particles lie elsewhere, by {Largest:0.##e0} m at most");

    private static double Distance((float X, float Y, float Z) a, (float X, float Y, float Z) b) =>
        Math.Sqrt(Math.Pow(a.X - b.X, 2) + Math.Pow(a.Y - b.Y, 2) + Math.Pow(a.Z - b.Z, 2));
}
