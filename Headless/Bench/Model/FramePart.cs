namespace Headless.Bench.Model;

/// <summary>A part of a frame besides its steps: a line of benchmarks/model/frame-parts.csv.</summary>
/// <param name="Config">Row of the bench's table of surfaces.</param>
/// <param name="Column">Its milliseconds there.</param>
/// <param name="Resource">What bounds it: issue or dispatches.</param>
/// <param name="InFrame">Whether a frame of water has it.</param>
internal sealed record FramePart(string Name, string Config, string Column, string Resource, bool InFrame)
{
    /// <summary>What the measured card's time is multiplied by.</summary>
    /// <exception cref="UsageException">The resource is not known.</exception>
    public double Ratio(NamedGpu measured, NamedGpu gpu) => Resource switch
    {
        "issue" => measured.LaneRate / gpu.LaneRate,
        "dispatches" => gpu.Dispatch / measured.Dispatch,
        _ => throw new UsageException($"benchmarks/model/frame-parts.csv: '{Resource}' is not a resource; issue and dispatches are."),
    };
}

/// <summary>Times of the parts of a frame besides its steps: those of the measured card, times the ratio of the cards.</summary>
internal sealed class FrameParts(ModelTables tables)
{
    private readonly IReadOnlyList<ModelRow> surface = tables.Measured("surface");

    /// <summary>Seconds on the measured card, on the line through both measured sizes.</summary>
    public double Measured(FramePart part, double particles)
    {
        ModelRow[] rows = [.. surface.Where(r => r.Text("config") == part.Config).OrderBy(r => r.Number("particles"))];
        if (rows.Length < 2) throw new UsageException($"the table of surfaces has no two sizes of '{part.Config}'.");
        (ModelRow few, ModelRow many) = (rows[0], rows[^1]);
        double n = few.Number("particles"), slope = (many.Number(part.Column) - few.Number(part.Column)) / (many.Number("particles") - n);
        return 1e-3 * Math.Max(few.Number(part.Column) + slope * (particles - n), few.Number(part.Column) * Math.Min(1, particles / n));
    }

    public double Seconds(FramePart part, NamedGpu gpu, double particles) => Measured(part, particles) * part.Ratio(tables.Card, gpu);

    /// <summary>Seconds of surface and drawing of a frame of water.</summary>
    public double Frame(NamedGpu gpu, double particles) => tables.FrameParts.Where(p => p.InFrame).Sum(p => Seconds(p, gpu, particles));
}
