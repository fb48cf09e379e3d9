using System.Text.Json;

namespace Headless.Measure.Page;

/// <summary>Lines of a plot, for the page's script.</summary>
/// <param name="Log">Whether both axes are logarithmic.</param>
internal sealed record Plot(string Title, string X, string Y, bool Log, IReadOnlyList<PlotLine> Lines)
{
    public void Write(Utf8JsonWriter json, string name)
    {
        json.WriteStartObject(name);
        json.WriteString("title", Title);
        json.WriteString("x", X);
        json.WriteString("y", Y);
        json.WriteBoolean("log", Log);
        json.WriteStartArray("lines");
        foreach (PlotLine line in Lines)
        {
            json.WriteStartObject();
            json.WriteString("name", line.Name);
            json.WriteNumber("colour", line.Colour);
            json.WriteBoolean("estimate", line.IsEstimate);
            json.WriteStartArray("points");
            foreach ((double x, double y) in line.Points.Where(p => double.IsFinite(p.X) && double.IsFinite(p.Y) && (!Log || p is { X: > 0, Y: > 0 })))
            {
                json.WriteStartArray();
                json.WriteNumberValue(x);
                json.WriteNumberValue(y);
                json.WriteEndArray();
            }
            json.WriteEndArray();
            json.WriteEndObject();
        }
        json.WriteEndArray();
        json.WriteEndObject();
    }
}

/// <summary>A line; lines of one colour belong together.</summary>
internal sealed record PlotLine(string Name, int Colour, bool IsEstimate, IReadOnlyList<(double X, double Y)> Points);
