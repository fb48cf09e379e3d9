using System.Globalization;

namespace Headless.Bench.Model;

/// <summary><c>./run model</c>: what steps would take on GPUs that are not at hand, with what is assumed beside every figure.</summary>
internal static class ModelCommand
{
    private const string WaveHead = "state,particles,radius_m,lanes,candidates,neighbours,candidate_turns,rows,neighbour_turns";

    internal static readonly IReadOnlyList<Flag> Flags =
    [
        new("--state", "FILE.ply", "counts the turns of waves anew, of what play --state wrote"),
        new("--radius", "R", "radius of neighbours in that file, in metres"),
    ];

    public static int Run(string root, IReadOnlyList<string> words)
    {
        string folder = Path.Combine(root, "benchmarks/model"), waveFile = Path.Combine(folder, "waves.csv");
        var arguments = new Arguments("model", words, Flags);
        if (arguments.Has("--state") != arguments.Has("--radius"))
            throw new UsageException("--state and --radius go together: a file of particles and the radius of their neighbours.");
        if (arguments.Text("--state") is { } state) return Measure(state, (float)arguments.Number("--radius", 0, 1e-6, 1e6, "metres"), waveFile);
        var compiled = CompiledLoops.Read(Path.Combine(root, "Headless/Checks/Gpu/Data/loops.csv"));
        string[][] measured = Rows(waveFile);
        var waves = measured.Select(r => new WaveStatistics(
            Int(r[3]), Number(r[4]), Number(r[5]), Number(r[6]), Number(r[7]), Number(r[8]))).ToDictionary(w => w.Lanes);
        var loops = Rows(Path.Combine(folder, "loops.csv")).Select(r => new PassLoop(r[0], r[1], r[2], r[3], r[4] == "neighbours", Number(r[5]), r[6] == "yes", Number(r[7]))).ToList();
        var steps = Rows(Path.Combine(folder, "steps.csv")).Select(r => new ModelStep(r[0], r[1].Split('+'), [Int(r[2]), Int(r[3])], Number(r[4]), Number(r[5]))).ToList();
        var model = new StepModel(compiled, loops, steps, waves);
        Console.WriteLine($"Estimates, not measurements: loops compiled by {compiled.Compiler}; turns of {measured[0][0]}, {measured[0][1]} particles, R = {measured[0][2]} m:");
        foreach (WaveStatistics w in waves.Values)
            Console.WriteLine(FormattableString.Invariant($"  waves of {w.Lanes}: {w.Candidates:0.0} candidates and {w.Neighbours:0.0} neighbours a lane; {w.CandidateTurns:0.0} and {w.NeighbourTurns:0.0} turns, {w.Rows:0.0} rows"));
        foreach (NamedGpu gpu in NamedGpu.All) Console.WriteLine("  " + gpu.Assumptions);
        Console.WriteLine("  " + StepModel.Assumptions);
        foreach (PassLoop loop in loops)
            Console.WriteLine(FormattableString.Invariant($"  {loop.Pass}: loop '{loop.Loop}' of {loop.Kernel}, {loop.PerTurn:0} {(loop.OverNeighbours ? "neighbours" : "candidates")} a turn, in {loop.Share:P0} of the waves{(loop.Gathers ? ", loads where a list says" : "")}"));
        foreach (string line in model.PassLines().Concat(model.StepLines())) Console.WriteLine(line);
        return 0;
    }

    private static int Measure(string state, float radius, string file)
    {
        var positions = ParticleState.Read(state);
        var lines = new List<string> { WaveHead };
        foreach (int lanes in new[] { 32, 64 })
        {
            WaveStatistics w = WaveStatistics.Of(positions, radius, lanes);
            lines.Add(FormattableString.Invariant(
                $"{Path.GetFileNameWithoutExtension(state)},{positions.Length},{radius},{lanes},{w.Candidates:0.##},{w.Neighbours:0.##},{w.CandidateTurns:0.##},{w.Rows:0.##},{w.NeighbourTurns:0.##}"));
        }
        File.WriteAllLines(file, lines);
        Console.WriteLine(string.Join('\n', lines.Append(file)));
        return 0;
    }

    private static string[][] Rows(string file) => File.Exists(file)
        ? [.. File.ReadLines(file).Skip(1).Where(line => line.Length > 0).Select(line => line.Split(','))]
        : throw new UsageException($"'{file}' is missing.");

    private static int Int(string text) => int.Parse(text, CultureInfo.InvariantCulture);

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
}
