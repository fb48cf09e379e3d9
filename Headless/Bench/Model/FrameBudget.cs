namespace Headless.Bench.Model;

/// <summary>Steps of a frame at 60 frames a second, as Dam Break has them.</summary>
/// <param name="At16K">With 16,384 particles; a step is shorter by N^(1/3), as its spacing is.</param>
/// <param name="Step">The mean of steps that it takes.</param>
internal sealed record FrameSteps(string Name, double At16K, string Step)
{
    /// <summary>Dam Break in its first second, and after four.</summary>
    public static readonly FrameSteps[] All = [new("in motion", 11, "Standard mean of 4"), new("calm", 4, "Standard mean of 8")];

    public double At(double particles) => Math.Max(1, At16K * Math.Cbrt(particles / 16384));
}

/// <summary>How many particles a frame has time for.</summary>
internal sealed class FrameBudget(StepModel model, FrameParts parts)
{
    public const double Seconds = 8e-3;

    /// <summary>At least and at most; 0 where not even 512 fit.</summary>
    public (double Low, double High) Particles(NamedGpu gpu, FrameSteps rate, Doubt doubt)
    {
        double Steps(double n) => rate.At(n) * model.Time(gpu, rate.Step, n).Total;
        return (Most(n => doubt.High * Steps(n) + parts.Frame(gpu, n).High), Most(n => doubt.Low * Steps(n) + parts.Frame(gpu, n).Low));
    }

    private static double Most(Func<double, double> seconds)
    {
        double low = 512, high = 64e6;
        if (seconds(low) > Seconds) return 0;
        while (high / low > 1.001)
        {
            double middle = Math.Sqrt(low * high);
            if (seconds(middle) <= Seconds) low = middle;
            else high = middle;
        }
        return low;
    }
}
