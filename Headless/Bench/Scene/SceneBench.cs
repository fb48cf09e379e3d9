namespace Headless.Bench.Scene;

/// <summary>What a simulated second of a scene costs, span by span; against an earlier build frame by frame in turns.</summary>
internal sealed class SceneBench(SceneOptions options)
{
    public int Run()
    {
        int frames = PairedPlay.Frames(options);
        var players = new List<PacedPlayer>();
        try
        {
            players.Add(PacedPlayer.Start(options, options.Build, frames));
            if (options.Against is { } other) players.Add(PacedPlayer.Start(options, other, frames));
            Console.WriteLine($"{frames} frames of {Path.GetFileName(options.Scene)}, {string.Join(" in turns with ", players.Select(p => $"{p.Build.Folder} ({p.Build.Commit})"))}.");
            new PairedPlay(options, players, frames).Run(frame => Console.WriteLine($"frame {frame} of {frames}"));
            Report(players);
            return 0;
        }
        finally
        {
            foreach (PacedPlayer player in players) player.Dispose();
        }
    }

    private void Report(List<PacedPlayer> players)
    {
        var rows = new List<SceneRow>();
        foreach (ScenePhase phase in options.Phases)
        {
            rows.Add(new SceneRow(options, players[0], phase, players.ElementAtOrDefault(1)));
            if (players.Count > 1) rows.Add(new SceneRow(options, players[1], phase, null));
        }
        if (options.AgainstTable is { } table) Compare(rows, table);
        SceneTable.Write(options, rows, options.Against?.Commit ?? options.AgainstTable ?? "");
        SceneTable.Say(rows, options);
        Console.WriteLine(Path.Combine(options.Out, SceneTable.FileName));
    }

    private static void Compare(List<SceneRow> rows, string file)
    {
        var earlier = SceneTable.Read(file);
        foreach (SceneRow row in rows)
        {
            if (!earlier.TryGetValue(row.Phase.Name, out var times)) continue;
            row.SolverRatio = Ratio.None with { OfSums = times.Solver / row.Solver };
            row.SurfaceRatio = Ratio.None with { OfSums = times.Surface / row.Surface };
            row.DrawingRatio = Ratio.None with { OfSums = times.Drawing / row.Drawing };
        }
    }
}
