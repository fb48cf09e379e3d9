namespace Headless.Bench.Model;

/// <summary>A part of a frame besides its steps: a line of benchmarks/model/frame-parts.csv.</summary>
/// <param name="Config">Row of the bench's table of surfaces.</param>
/// <param name="Column">Its milliseconds there.</param>
/// <param name="Resource">What bounds it: issue, graphics (issue for drawing) or dispatches.</param>
/// <param name="InFrame">Whether a frame of water has it.</param>
internal sealed record FramePart(string Name, string Config, string Column, string Resource, bool InFrame);

/// <summary>Times of the parts of a frame besides its steps: those of the measured card, times the ratio of the cards.</summary>
/// <param name="off">How far that ratio may be off, to either side.</param>
internal sealed class FrameParts(ModelTables tables, double off)
{
    private readonly IReadOnlyList<ModelRow> surface = tables.Measured("surface");

    public double Off => off;

    /// <summary>Seconds on the measured card: what no particle adds to, and what they add, on the line through both measured sizes.</summary>
    public (double Waiting, double Work) Measured(FramePart part, double particles)
    {
        ModelRow[] rows = [.. surface.Where(r => r.Text("config") == part.Config).OrderBy(r => r.Number("particles"))];
        if (rows.Length < 2) throw new UsageException($"the table of surfaces has no two sizes of '{part.Config}'.");
        double few = rows[0].Number("particles"), first = rows[0].Number(part.Column);
        double slope = (rows[^1].Number(part.Column) - first) / (rows[^1].Number("particles") - few);
        double waiting = Math.Max(0, first - slope * few);
        return (1e-3 * waiting, 1e-3 * (first + slope * (particles - few) < 0 ? first / few * particles : first + slope * (particles - few) - waiting));
    }

    /// <summary>Seconds at least and at most.</summary>
    /// <exception cref="UsageException">The resource is not known.</exception>
    public (double Low, double High) Seconds(FramePart part, NamedGpu gpu, double particles)
    {
        NamedGpu card = tables.Card;
        (double waiting, double work) = Measured(part, particles);
        if (gpu == card) return (waiting + work, waiting + work);
        double time = part.Resource switch
        {
            // What waits does so for a number of cycles.
            "issue" => waiting * card.Hertz / gpu.Hertz + work * card.LaneRate / gpu.LaneRate,
            "graphics" => (waiting + work) * card.GraphicsLaneRate / gpu.GraphicsLaneRate,
            "dispatches" => (waiting + work) * gpu.Dispatch / card.Dispatch,
            _ => throw new UsageException($"benchmarks/model/frame-parts.csv: '{part.Resource}' is not a resource; issue, graphics and dispatches are."),
        };
        // Drawing also needs what is not known to be more: units of raster, bytes of pictures.
        return (time / off, part.Resource == "graphics" ? Math.Max(time * off, waiting + work) : time * off);
    }

    /// <summary>Seconds of surface and drawing of a frame of water, at least and at most.</summary>
    public (double Low, double High) Frame(NamedGpu gpu, double particles)
    {
        var parts = tables.FrameParts.Where(p => p.InFrame).Select(p => Seconds(p, gpu, particles)).ToArray();
        return (parts.Sum(p => p.Low), parts.Sum(p => p.High));
    }
}
