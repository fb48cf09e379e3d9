namespace Headless.Measure.Results;

/// <summary>What the frames of a played scene took, of its timings.csv.</summary>
internal sealed record FrameTimes(IReadOnlyList<FrameTimes.Frame> Frames)
{
    // The device makes its kernels in these.
    private const int WarmUp = 2;

    private const string Pass = "gpu_ms.", WhitewaterWord = "Whitewater";

    /// <summary>Milliseconds of a frame.</summary>
    /// <param name="Gpu">Sum of its passes on the GPU.</param>
    internal sealed record Frame(int Number, double Time, double Steps, double Particles, double Cpu, double Gpu, double Whitewater);

    /// <summary>Null where there are no frames.</summary>
    public static FrameTimes? Read(string file)
    {
        CsvTable table = CsvTable.Read(file);
        string[] passes = [.. table.Head.Where(h => h.StartsWith(Pass, StringComparison.Ordinal))], spray = [.. passes.Where(p => p.Contains(WhitewaterWord))];
        Frame[] frames =
        [
            .. table.Rows.Select(row => new Frame((int)table.Number(row, "frame"), table.Number(row, "time_s"), Or0(table.Number(row, "steps")),
                table.Number(row, "particles"), table.Number(row, "cpu_ms"), passes.Sum(p => Or0(table.Number(row, p))), spray.Sum(p => Or0(table.Number(row, p))))),
        ];
        return frames.Length > 0 ? new FrameTimes(frames) : null;
    }

    public IEnumerable<Frame> Steady => Frames.Skip(Math.Min(WarmUp + 1, Frames.Count - 1));

    public IEnumerable<string> Lines()
    {
        Frame[] frames = [.. Steady];
        yield return FormattableString.Invariant(
            $"{frames[^1].Particles:0} particles; the first frame, with its kernels, took {Frames[0].Cpu / 1000:0.0} s; {Frames.Count} frames");
        yield return FormattableString.Invariant(
            $"a frame: {frames.Average(f => f.Gpu):0.00} ms GPU, {frames.Average(f => f.Cpu):0.0} ms CPU, {frames.Average(f => f.Steps):0.0} steps; whitewater {frames.Average(f => f.Whitewater):0.000} ms GPU");
    }

    private static double Or0(double value) => double.IsNaN(value) ? 0 : value;
}
