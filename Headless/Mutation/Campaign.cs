using System.Diagnostics;
using System.Globalization;
using System.Text.RegularExpressions;
using Headless.Files;
using Headless.Mutation.CSharp;
using Headless.Mutation.Hlsl;
using Headless.Mutation.Running;

namespace Headless.Mutation;

/// <summary>Draws the sample, makes each change in a copy of the project, runs what covers it and keeps the table.</summary>
internal sealed class Campaign
{
    private readonly Options options;
    private readonly string player;
    private readonly ProjectOverlay overlay;
    private readonly PackageCompilation package;
    private readonly string table;
    private readonly Dictionary<string, string> reasons;
    private readonly Dictionary<string, Row> rows;
    private readonly TestProcess tests;
    private readonly Dictionary<string, int> catches = new(StringComparer.Ordinal);
    private string dropped = "";

    public Campaign(Options options)
    {
        this.options = options;
        player = Path.Combine(options.Project, "Build/dotnet/bin/Headless.Player/release/sphplayer");
        string assemblies = Path.Combine(options.Project, "Build/ScriptAssemblies");
        if (!File.Exists(player) || !Directory.Exists(assemblies)) throw new UsageException("the project is not built: ./run build");
        Directory.CreateDirectory(options.Folder);
        player = CopyOf(Path.GetDirectoryName(player)!, Path.Combine(options.Folder, "player"));
        overlay = new ProjectOverlay(options.Project, assemblies, options.Folder);
        package = new PackageCompilation(Path.Combine(options.Project, "Packages/com.sphfluid"), Path.Combine(options.Project, "Build/dotnet/bin/SphFluid/release"));
        tests = new TestProcess(player, overlay, options.Folder, Cache);
        table = Path.Combine(options.OutFolder, "mutants.csv");
        reasons = Table.Reasons(Path.Combine(options.OutFolder, "reasons.csv"));
        rows = Table.Read(table).Select(Reasoned).ToDictionary(r => r.Mutant.Key, StringComparer.Ordinal);
        foreach (Row row in rows.Values.Where(r => r.Verdict == Row.Caught)) Count(row.By);
    }

    private string RecordedFile => Path.Combine(options.Folder, "recorded.txt");
    private string MapFile => Path.Combine(options.Folder, "coverage.txt");
    private string Cache => Path.Combine(options.Folder, "cache");
    private string ShaderCache => Path.Combine(UserCache.Below(Cache), "shaders");

    public int Run()
    {
        var marks = new MethodMarks(package);
        if (options.Map || !(File.Exists(MapFile) || File.Exists(RecordedFile))) Record(marks);
        if (File.Exists(RecordedFile)) TestMap.Merge(MapFile, RecordedFile, marks.Name);
        var map = new TestMap(MapFile);
        var variants = new KernelVariants(overlay, map.Kernels, ShaderCache);
        Console.WriteLine($"{map.Tests.Count} tests cover {map.Kernels.Count()} kernel variants of {variants.Files.Count} shader files");
        byte[] unchanged = package.Emit([], out string problem) ?? throw new UsageException($"the package does not compile: {problem}");
        TestAll("kernels", variants.Files, options.Shaders, f => HlslMutator.Find(f, overlay.Original(f)), m => Shader(m, variants, map));
        TestAll("scripts", package.Files, options.Scripts,
            f => CSharpMutator.Find(f, overlay.Original(f)), m => Script(m, marks, map, unchanged));
        tests.Dispose();
        if (!options.List) Table.Write(table, rows.Values);
        Print();
        return 0;
    }

    private void TestAll(string name, IEnumerable<string> files, int count, Func<string, IReadOnlyList<Mutant>> find, Func<Mutant, IReadOnlyList<MappedTest>?> make)
    {
        IReadOnlyList<Mutant>[] found = [.. files.Where(f => Regex.IsMatch(f, options.Files)).Select(find)];
        Forget(found);
        Console.WriteLine($"{name}: {found.Sum(f => f.Count)} changes of {found.Length} files, {count} of them asked for");
        var sample = new Sample(found, options.Seed);
        for (int done = 0; done < count && sample.Next() is { } mutant;)
        {
            bool known = rows.TryGetValue(mutant.Key, out Row? old);
            if (known && old!.IsDropped)
            {
                sample.Drop(mutant);
                continue;
            }
            done++;
            if (options.List) Console.WriteLine($"{mutant.File}:{mutant.Line} {mutant.Operator} {mutant.Change}    {mutant.Source}");
            if (options.List || !IsDue(mutant, old)) continue;
            var clock = Stopwatch.StartNew();
            IReadOnlyList<MappedTest>? covering = make(mutant);
            Row row = covering is null ? new Row(mutant, 0, 0, "", dropped, "", "") : Test(mutant, covering, old);
            if (covering is null)
            {
                sample.Drop(mutant);
                done--;
            }
            rows[mutant.Key] = row;
            Table.Write(table, rows.Values);
            Console.WriteLine(string.Create(CultureInfo.InvariantCulture,
                $"{done}/{count} {row.Verdict,-10} {mutant.File}:{mutant.Line} {mutant.Operator} {mutant.Change} ({row.Run} of {row.Covering} tests, {clock.Elapsed.TotalSeconds:0} s) {row.By} {row.Detail}"));
        }
    }

    private bool IsDue(Mutant mutant, Row? old)
    {
        if (options.Only.Length > 0 && !Regex.IsMatch(mutant.File, options.Only)) return false;
        if (options.Survivors) return old?.Verdict == Row.Survived;
        return old is null || options.Again;
    }

    // Rows of lines and files that are no more.
    private void Forget(IEnumerable<IReadOnlyList<Mutant>> found)
    {
        HashSet<string> keys = [.. found.SelectMany(f => f).Select(m => m.Key)], files = [.. found.SelectMany(f => f).Select(m => m.File)];
        foreach (string key in rows.Values.Select(r => r.Mutant).Where(m => files.Contains(m.File) ? !keys.Contains(m.Key) : !overlay.Has(m.File)).Select(m => m.Key).ToList())
            rows.Remove(key);
    }

    /// <summary>Makes a change of a shader in the overlay; the tests that run what it changed, or null when it made no other program.</summary>
    private IReadOnlyList<MappedTest>? Shader(Mutant mutant, KernelVariants variants, TestMap map)
    {
        overlay.WriteShader(mutant.File, mutant.Apply(overlay.Original(mutant.File)));
        IReadOnlyList<string>? affected = variants.Affected(mutant.File, out _);
        if (affected is { Count: > 0 }) return [.. Ranked(map.OfKernels(affected))];
        dropped = affected is null ? Row.Invalid : Row.Same;
        overlay.RestoreShader(mutant.File);
        return null;
    }

    private IReadOnlyList<MappedTest>? Script(Mutant mutant, MethodMarks marks, TestMap map, byte[] unchanged)
    {
        byte[]? assembly = package.Emit([(mutant.File, mutant.Apply(overlay.Original(mutant.File)))], out _);
        if (assembly is null || assembly.AsSpan().SequenceEqual(unchanged))
        {
            dropped = assembly is null ? Row.Invalid : Row.Same;
            return null;
        }
        overlay.WriteAssembly(PackageCompilation.AssemblyName, assembly);
        // What a static initialiser makes is entered by the first test alone: the others of the file follow.
        IReadOnlyList<MappedTest> near = map.OfMethods(marks.At(mutant.File, mutant.Start));
        return [.. Ranked(near), .. Ranked(map.OfMethods(marks.Of(mutant.File)).Except(near))];
    }

    private Row Test(Mutant mutant, IReadOnlyList<MappedTest> covering, Row? old)
    {
        bool shader = IsShader(mutant);
        List<MappedTest> order = Affordable(covering);
        TestVerdict verdict = new(null, "", 0);
        if (!shader) tests.Restart();
        if (order.Count > 0)
        {
            bool fresh = tests.Runs == 0;
            verdict = tests.Run(order);
            if (shader && !fresh && IsDirty(mutant, verdict, covering))
            {
                tests.Restart();
                overlay.WriteShader(mutant.File, mutant.Apply(overlay.Original(mutant.File)));
                verdict = tests.Run(order);
            }
        }
        if (shader) overlay.RestoreShader(mutant.File);
        else tests.Restart();
        if (verdict.CaughtBy is { } test) Count(test);
        bool caught = verdict.CaughtBy is not null, reasoned = reasons.ContainsKey(mutant.Key);
        string detail = caught ? verdict.Reason : reasons.GetValueOrDefault(mutant.Key, covering.Count == 0 ? "no test covers it" : "");
        return new Row(mutant, covering.Count, verdict.Run, old is null or { IsDropped: true } ? (caught ? Row.Caught : Row.Survived) : old.First,
            caught ? Row.Caught : reasoned ? Row.Equivalent : Row.Survived, verdict.CaughtBy ?? "", detail);
    }

    // Whether a test that failed in a player which ran other changes before fails there without the change as well.
    private bool IsDirty(Mutant mutant, TestVerdict verdict, IReadOnlyList<MappedTest> covering)
    {
        if (verdict.CaughtBy is null || tests.Runs == 0) return false;
        overlay.RestoreShader(mutant.File);
        return tests.Run([.. covering.Where(t => t.Name == verdict.CaughtBy)]).CaughtBy is not null;
    }

    // A reason given since the last run holds without another one.
    private Row Reasoned(Row row)
    {
        if (row.Verdict is not (Row.Survived or Row.Equivalent)) return row;
        return reasons.TryGetValue(row.Mutant.Key, out string? reason)
            ? row with { Verdict = Row.Equivalent, Detail = reason }
            : row with { Verdict = Row.Survived };
    }

    private static bool IsShader(Mutant mutant) => mutant.File.StartsWith("Shaders/", StringComparison.Ordinal);

    // What has caught much before, and what is quick, goes first.
    private IEnumerable<MappedTest> Ranked(IEnumerable<MappedTest> tests) =>
        tests.OrderBy(t => (t.Seconds + 0.1) / (1.0 + catches.GetValueOrDefault(t.Name))).ThenBy(t => t.Name, StringComparer.Ordinal);

    private List<MappedTest> Affordable(IReadOnlyList<MappedTest> covering)
    {
        List<MappedTest> chosen = [];
        double seconds = 0.0;
        foreach (MappedTest test in covering)
        {
            seconds += test.Seconds;
            if (seconds > options.Seconds && chosen.Count > 0) break;
            chosen.Add(test);
        }
        return chosen;
    }

    // A campaign takes long: meanwhile the project may be built anew.
    private static string CopyOf(string from, string to)
    {
        if (Directory.Exists(to)) Directory.Delete(to, recursive: true);
        foreach (string file in Directory.EnumerateFiles(from, "*", SearchOption.AllDirectories))
        {
            string copy = Path.Combine(to, Path.GetRelativePath(from, file));
            Directory.CreateDirectory(Path.GetDirectoryName(copy)!);
            File.Copy(file, copy);
        }
        return Path.Combine(to, "sphplayer");
    }

    private void Record(MethodMarks marks)
    {
        Console.WriteLine("recording which test covers what...");
        byte[] marked = package.Emit(marks.Marked, out string problem) ?? throw new UsageException($"the package with marks does not compile: {problem}");
        overlay.WriteAssembly(PackageCompilation.AssemblyName, marked);
        List<string> words = ["-n", "10", player, "test", "--project", overlay.Project, "--assemblies", overlay.Assemblies, "--coverage", RecordedFile];
        if (options.MapFilter.Length > 0) words.AddRange(["--filter", options.MapFilter]);
        using Process process = Process.Start(new ProcessStartInfo("nice", words))!;
        process.WaitForExit();
        overlay.RestoreAssembly(PackageCompilation.AssemblyName);
    }

    private void Count(string test) => catches[test] = catches.GetValueOrDefault(test) + 1;

    private void Print()
    {
        int Number(string verdict) => rows.Values.Count(r => r.Verdict == verdict);
        int caught = Number(Row.Caught), survived = Number(Row.Survived), equivalent = Number(Row.Equivalent);
        Row[] changes = [.. rows.Values.Where(r => !r.IsDropped)];
        int first = changes.Count(r => r.First == Row.Caught);
        double share = caught + survived > 0 ? 100.0 * caught / (caught + survived) : 0.0;
        Console.WriteLine($"{Number(Row.Invalid)} did not compile and {Number(Row.Same)} made the same program: they are not counted");
        Console.WriteLine(string.Create(CultureInfo.InvariantCulture,
            $"{changes.Length} changes: {caught} caught, {survived} survived, {equivalent} equivalent: {share:0.0} % of those that matter are caught; {first} of {changes.Length} at their first run"));
    }
}
