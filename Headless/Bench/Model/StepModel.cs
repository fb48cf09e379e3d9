using System.Globalization;

namespace Headless.Bench.Model;

/// <summary>Which loops a pass has: a line of benchmarks/model/loops.csv.</summary>
/// <param name="PerTurn">Candidates or neighbours that a turn takes.</param>
/// <param name="Gathers">Whether its loads go where a list says.</param>
/// <param name="Share">Part of the waves that go through it.</param>
internal sealed record PassLoop(string Pass, string Kernel, string Keywords, string Loop, bool OverNeighbours, double PerTurn, bool Gathers, double Share);

/// <summary>A step: a line of benchmarks/model/steps.csv.</summary>
/// <param name="Passes">Names of its passes; or, with a number before each as "1 rebuilt", of steps that it is the mean of.</param>
/// <param name="Dispatches">Dispatches at 65,536 and 1,048,576 particles.</param>
/// <param name="SortBytes">Bytes a particle that are moved besides the passes.</param>
/// <param name="ListBytes">Bytes a particle of the list, written and read.</param>
internal sealed record ModelStep(string Name, string[] Passes, int[] Dispatches, double SortBytes, double ListBytes);

/// <summary>Times of steps on GPUs that are not at hand, from compiled loops and the turns that waves take through them.</summary>
internal sealed class StepModel(CompiledLoops compiled, IReadOnlyList<PassLoop> loops, IReadOnlyList<ModelStep> steps, IReadOnlyDictionary<int, WaveStatistics> waves)
{
    public static readonly int[] Sizes = [65536, 1048576];

    // Finding a row of cells: two loads behind each other and their arithmetic.
    private const double RowCycles = 45, RowInstructions = 40, RowChain = 255;

    // Bits of a chunk of 32 candidates, put right and stored; rows have about 27, so a chunk each.
    private const double ChunkCycles = 60, ChunkInstructions = 26, ChunkChain = 100;

    // Small passes of a step besides, and the part of the list's traffic that the passes do not hide.
    private const double SmallPasses = 4e-6, HiddenByWork = 0.5;

    public static string Assumptions => FormattableString.Invariant(
        $"a row of cells {RowCycles:0} cycles (AMD) or {RowInstructions:0} instructions (NVIDIA), {RowChain:0} cycles if nothing else runs, in chunks {ChunkCycles:0}, {ChunkInstructions:0} and {ChunkChain:0} more; small passes {SmallPasses * 1e6:0} us up to 65,536 particles; ")
        + "half of a pass's time hides the list's bytes; no walls, no tail of a pass. The method was within 1 to 1.5 of a published pass of an H100.";

    public IEnumerable<string> PassLines()
    {
        yield return $"{"pass",-26}{"GPU",-12}{"turns a wave",14}{"issue/turn",12}{"chain/turn",12}{"64 K us",10}{"1 M us",10}";
        foreach (string pass in loops.Select(l => l.Pass).Distinct())
            foreach (NamedGpu gpu in NamedGpu.All)
            {
                PassLoop[] own = [.. loops.Where(l => l.Pass == pass)];
                string turns = string.Join('+', own.Select(l => (l.Share * Turns(gpu, l)).ToString("0.0", CultureInfo.InvariantCulture)));
                string issue = string.Join('+', own.Select(l => gpu.Issue(Compiled(gpu, l)).ToString("0", CultureInfo.InvariantCulture)));
                string chain = string.Join('+', own.Select(l => gpu.Chain(Compiled(gpu, l), l.Gathers).ToString("0", CultureInfo.InvariantCulture)));
                yield return string.Create(CultureInfo.InvariantCulture,
                    $"{pass,-26}{gpu.Name,-12}{turns,14}{issue,12}{chain,12}{1e6 * PassTime(gpu, pass, Sizes[0]),10:0.0}{1e6 * PassTime(gpu, pass, Sizes[1]),10:0.0}");
            }
    }

    public IEnumerable<string> StepLines()
    {
        yield return $"{"step",-26}{"GPU",-12}{"dispatches",12}{"sort B",8}{"list B",8}{"64 K us",10}{"1 M us",10}";
        foreach (ModelStep step in steps)
            foreach (NamedGpu gpu in NamedGpu.All)
                yield return string.Create(CultureInfo.InvariantCulture,
                    $"{step.Name,-26}{gpu.Name,-12}{string.Join('/', step.Dispatches),12}{step.SortBytes,8:0}{step.ListBytes,8:0}{1e6 * StepTime(gpu, step, 0),10:0.0}{1e6 * StepTime(gpu, step, 1),10:0.0}");
    }

    /// <summary>Seconds of a step at <see cref="Sizes"/>.</summary>
    public double StepTime(NamedGpu gpu, ModelStep step, int size)
    {
        if (char.IsAsciiDigit(step.Passes[0][0])) return Mean(gpu, step, size);
        int particles = Sizes[size];
        double work = step.Passes.Sum(pass => PassTime(gpu, pass, particles));
        double list = gpu.Move(step.ListBytes * particles);
        return work + gpu.Move(step.SortBytes * particles) + Math.Max(0, list - HiddenByWork * work) + step.Dispatches[size] * gpu.Dispatch + (size == 0 ? SmallPasses : 0);
    }

    private double Mean(NamedGpu gpu, ModelStep step, int size)
    {
        double time = 0, count = 0;
        foreach (string part in step.Passes)
        {
            string[] words = part.Split(' ', 2);
            double times = double.Parse(words[0], CultureInfo.InvariantCulture);
            time += times * StepTime(gpu, steps.First(s => s.Name == words[1]), size);
            count += times;
        }
        return time / count;
    }

    private double PassTime(NamedGpu gpu, string pass, int particles)
    {
        double issue = 0, chain = 0;
        bool searches = false, inChunks = false;
        foreach (PassLoop loop in loops.Where(l => l.Pass == pass))
        {
            double turns = loop.Share * Turns(gpu, loop);
            issue += turns * gpu.Issue(Compiled(gpu, loop));
            chain += turns * gpu.Chain(Compiled(gpu, loop), loop.Gathers);
            searches |= !loop.OverNeighbours;
            inChunks |= !loop.OverNeighbours && loop.PerTurn > 1;
        }
        double rows = waves[gpu.Lanes].Rows;
        if (searches)
        {
            issue += rows * (gpu.CountsInstructions ? RowInstructions : RowCycles);
            chain += rows * RowChain;
        }
        if (inChunks)
        {
            issue += rows * (gpu.CountsInstructions ? ChunkInstructions : ChunkCycles);
            chain += rows * ChunkChain;
        }
        return gpu.Time(particles, issue, chain);
    }

    private double Turns(NamedGpu gpu, PassLoop loop)
    {
        WaveStatistics wave = waves[gpu.Lanes];
        // A row's last turn takes what is left of it.
        double rest = (loop.PerTurn - 1) / 2 * (loop.OverNeighbours ? 1 : wave.Rows);
        return ((loop.OverNeighbours ? wave.NeighbourTurns : wave.CandidateTurns) + rest) / loop.PerTurn;
    }

    private CompiledLoop Compiled(NamedGpu gpu, PassLoop loop) => compiled[gpu.Family, loop.Kernel, loop.Keywords, loop.Loop];
}
