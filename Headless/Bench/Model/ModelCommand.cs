namespace Headless.Bench.Model;

/// <summary><c>./run model</c>: what steps and frames would take on GPUs that are not at hand, with what is assumed beside every figure.</summary>
internal static class ModelCommand
{
    private const string WaveHead = "state,particles,kappa,radius_m,lanes,candidates,neighbours,candidate_turns,rows,neighbour_turns";

    internal static readonly IReadOnlyList<Flag> Flags =
    [
        new("--state", "FILE.ply", "counts the turns of waves anew, of what play --state wrote"),
        new("--spacing", "DX", "spacing of the particles in that file, in metres"),
    ];

    // Radii of neighbours that the state is evaluated with, in spacings; the second is the default.
    private static readonly double[] Kappas = [2, 2.25];

    public static int Run(string root, IReadOnlyList<string> words)
    {
        var arguments = new Arguments("model", words, Flags);
        if (arguments.Has("--state") != arguments.Has("--spacing"))
            throw new UsageException("--state and --spacing go together: a file of particles and their spacing.");
        if (arguments.Text("--state") is { } state)
            return Measure(state, arguments.Number("--spacing", 0, 1e-6, 1e6, "metres"), Path.Combine(root, "benchmarks/model/waves.csv"));
        foreach (string line in new ModelReport(new ModelTables(root)).Lines()) Console.WriteLine(line);
        return 0;
    }

    private static int Measure(string state, double spacing, string file)
    {
        var positions = ParticleState.Read(state);
        var lines = new List<string> { WaveHead };
        foreach (double kappa in Kappas)
            foreach (int lanes in new[] { 32, 64 })
            {
                WaveStatistics w = WaveStatistics.Of(positions, (float)(kappa * spacing), lanes);
                lines.Add(FormattableString.Invariant($"{Path.GetFileNameWithoutExtension(state)},{positions.Length},{kappa},{kappa * spacing:0.#######},{lanes},")
                    + FormattableString.Invariant($"{w.Candidates:0.##},{w.Neighbours:0.##},{w.CandidateTurns:0.##},{w.Rows:0.##},{w.NeighbourTurns:0.##}"));
            }
        File.WriteAllLines(file, lines);
        Console.WriteLine(string.Join('\n', lines.Append(file)));
        return 0;
    }
}
