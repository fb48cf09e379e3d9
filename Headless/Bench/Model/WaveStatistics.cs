namespace Headless.Bench.Model;

/// <summary>
/// What the waves of a GPU do with a liquid whose particles are sorted by cells: lanes go through a loop together, so a wave takes as many
/// turns as its longest lane.
/// </summary>
/// <param name="Lanes">Lanes of a wave.</param>
/// <param name="Candidates">Particles that a lane tests, itself included.</param>
/// <param name="Neighbours">Particles within R of a lane's, itself not included.</param>
/// <param name="CandidateTurns">Turns of a wave over candidates, row of cells by row.</param>
/// <param name="Rows">Rows of cells that are not empty for all lanes, of nine.</param>
/// <param name="NeighbourTurns">Turns of a wave over lists of neighbours.</param>
internal sealed record WaveStatistics(int Lanes, double Candidates, double Neighbours, double CandidateTurns, double Rows, double NeighbourTurns)
{
    /// <param name="radius">R, also the edge of a cell.</param>
    public static WaveStatistics Of(IReadOnlyList<(float X, float Y, float Z)> positions, float radius, int lanes)
    {
        var cells = new CellRuns(positions, radius);
        long candidates = 0, neighbours = 0, candidateTurns = 0, rows = 0, neighbourTurns = 0;
        int waves = 0;
        for (int first = 0; first < cells.Count; first += lanes, waves++)
        {
            int last = Math.Min(first + lanes, cells.Count), longestList = 0;
            for (int row = 0; row < 9; row++)
            {
                int longest = 0;
                for (int i = first; i < last; i++)
                {
                    (int begin, int end) = cells.Run(i, row);
                    longest = Math.Max(longest, end - begin);
                    candidates += end - begin;
                }
                candidateTurns += longest;
                rows += longest > 0 ? 1 : 0;
            }
            for (int i = first; i < last; i++)
            {
                int found = cells.Neighbours(i);
                neighbours += found;
                longestList = Math.Max(longestList, found);
            }
            neighbourTurns += longestList;
        }
        double n = cells.Count;
        return new WaveStatistics(lanes, candidates / n, neighbours / n, (double)candidateTurns / waves, (double)rows / waves, (double)neighbourTurns / waves);
    }
}
