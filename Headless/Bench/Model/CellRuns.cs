namespace Headless.Bench.Model;

/// <summary>Particles sorted by cells of R, x running fastest, and the nine rows of three cells around each.</summary>
internal sealed class CellRuns
{
    private readonly (float X, float Y, float Z)[] sorted;
    private readonly (int X, int Y, int Z)[] cellOf;
    private readonly int[] start;
    private readonly int countX, countY;
    private readonly float radius;

    public CellRuns(IReadOnlyList<(float X, float Y, float Z)> positions, float radius)
    {
        this.radius = radius;
        float lowX = positions.Min(p => p.X), lowY = positions.Min(p => p.Y), lowZ = positions.Min(p => p.Z);
        // An empty cell around all.
        int Cell(float value, float low) => 1 + (int)((value - low) / radius);
        var cells = positions.Select(p => (X: Cell(p.X, lowX), Y: Cell(p.Y, lowY), Z: Cell(p.Z, lowZ))).ToArray();
        (countX, countY) = (cells.Max(c => c.X) + 2, cells.Max(c => c.Y) + 2);
        int[] order = [.. Enumerable.Range(0, cells.Length).OrderBy(i => Number(cells[i].X, cells[i].Y, cells[i].Z))];
        sorted = [.. order.Select(i => positions[i])];
        cellOf = [.. order.Select(i => cells[i])];
        start = new int[Number(0, 0, cells.Max(c => c.Z) + 2) + 1];
        foreach (var (x, y, z) in cells) start[Number(x, y, z) + 1]++;
        for (int i = 1; i < start.Length; i++) start[i] += start[i - 1];
    }

    public int Count => sorted.Length;

    public (int Begin, int End) Run(int particle, int row)
    {
        var (x, y, z) = cellOf[particle];
        int first = Number(x - 1, y + row % 3 - 1, z + row / 3 - 1);
        return (start[first], start[first + 3]);
    }

    public int Neighbours(int particle)
    {
        int found = 0;
        var at = sorted[particle];
        for (int row = 0; row < 9; row++)
        {
            (int begin, int end) = Run(particle, row);
            for (int j = begin; j < end; j++)
            {
                float x = sorted[j].X - at.X, y = sorted[j].Y - at.Y, z = sorted[j].Z - at.Z;
                found += j != particle && x * x + y * y + z * z < radius * radius ? 1 : 0;
            }
        }
        return found;
    }

    private int Number(int x, int y, int z) => (z * countY + y) * countX + x;
}
