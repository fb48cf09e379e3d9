namespace Headless.Checks.Fxc;

/// <summary>What FXC made of a job: a line of fxc_jobs.c.</summary>
/// <param name="Uavs">Buffers and textures that are written.</param>
/// <param name="Buffers">Buffers that are read or written.</param>
/// <param name="Kilobytes">Memory that the compilation asked for: it grows with the work of the optimiser, and is the same on every machine.</param>
/// <param name="Milliseconds">CPU time of the compilation.</param>
internal sealed record FxcResult(
    FxcJob Job, bool Ok, int Uavs, int SharedBytes, int Threads, int Slots, string Messages, int Buffers, int Kilobytes, int Milliseconds)
{
    /// <summary>Whether the compiler fell over, which says nothing of the kernel when it happens once.</summary>
    public bool HasCrashed => !Ok && Messages.Contains("crashed", StringComparison.Ordinal);

    public static FxcResult Parse(string line, IReadOnlyList<FxcJob> jobs)
    {
        var fields = line.Split('\t');
        int Number(int at) => fields.Length > at && int.TryParse(fields[at], out var value) ? value : 0;
        return new FxcResult(
            jobs[int.Parse(fields[0])], fields[1] == "ok", Number(2), Number(3), Number(4), Number(5),
            fields.Length > 6 ? fields[6].Trim() : "", Number(7), Number(8), Number(9));
    }
}
