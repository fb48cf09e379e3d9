using Headless.Checks.Shaders;
using Headless.Shaders;

namespace Headless.Checks.Gpu;

/// <summary>Compiles every kernel and pass for two families of GPUs by Mesa's RADV on null hardware, and holds registers, spills, scratch
/// and groupshared memory, waves and the hot loops against committed tables.</summary>
/// <param name="tableFolder">Where the tables are.</param>
/// <param name="families">Those that are compiled for; null for all.</param>
internal sealed class GpuCheck(ProjectPackages packages, string shaderCache, string tableFolder, IReadOnlyList<GpuFamily>? families = null)
{
    private const string Compiler = "glslangValidator";

    /// <param name="update">Writes the tables anew in place of holding the results against them.</param>
    public IEnumerable<CheckReport> Run(bool update)
    {
        if (NullHardware.DriverFile is null) return [Skipped("Mesa's RADV is not installed: apt-get install mesa-vulkan-drivers")];
        if (new GlslangProcess(Compiler).Version is not { } front) return [Skipped($"{Compiler} is not installed: apt-get install glslang-tools")];
        var problems = new List<string>();
        Prewarm(problems);
        if (problems.Count > 0) return [Failed(problems)];
        var hardware = new NullHardware(packages.Project, shaderCache);
        var results = (families ?? GpuFamily.All).AsParallel().AsOrdered().Select(hardware.Compile).ToList();
        foreach (var result in results.Where(r => r.SkippedBecause is null)) result.RequireHotLoops();
        return update ? [Update(results, front)] : Compare(results, front);
    }

    private static CheckReport Skipped(string reason) => new("GPU compiler") { SkippedBecause = reason };

    private static CheckReport Failed(IEnumerable<string> problems)
    {
        var report = new CheckReport("GPU compiler") { Figures = "the package's shaders do not compile" };
        report.Findings.AddRange(problems);
        return report;
    }

    private static string Toolchain(FamilyResult result, string front) => $"Mesa {result.MesaVersion}, {front}";

    // On all cores here, so that the children find the SPIR-V in the cache.
    private void Prewarm(List<string> problems)
    {
        var includes = new IncludeResolver(packages.Project);
        var compiler = new ShaderCompiler(shaderCache, includes);
        var variants = ShaderVariants.Read(packages, includes, problems);
        if (variants.Count == 0 && problems.Count == 0) problems.Add($"no shaders below {packages.Folder}");
        try { compiler.Prewarm(variants.Select(v => v.Request)); }
        catch (ShaderCompileException e) { problems.Add(e.Message); }
        if (compiler.CacheProblem is { } cache) problems.Add(cache);
    }

    private CheckReport Update(List<FamilyResult> results, string front)
    {
        var problems = results.SelectMany(r => r.SkippedBecause is { } reason ? [$"{r.Family.Name}: {reason}"] : r.Problems).ToList();
        if (problems.Count > 0) return Failed([.. problems, "the tables are left as they were"]);
        var tables = new CompiledTables(Toolchain(results[0], front));
        foreach (var result in results) Fill(tables, result);
        tables.Write(tableFolder);
        return new CheckReport("GPU compiler")
        {
            Figures = $"{tables.Programs.Rows.Count} programs and {tables.Loops.Rows.Count} hot loops of {tables.Programs.Toolchain} written to {tableFolder}",
        };
    }

    private IEnumerable<CheckReport> Compare(List<FamilyResult> results, string front)
    {
        if (!CompiledTables.Exist(tableFolder)) return [Failed([$"no tables in {tableFolder}: write them with ./run check --only gpu --update"])];
        try
        {
            var committed = CompiledTables.Read(tableFolder);
            return results.Select(result => Compare(committed.Of(result.Family), result, Toolchain(result, front))).ToList();
        }
        catch (FormatException e) { return [Failed([e.Message])]; }
    }

    private static CheckReport Compare(CompiledTables committed, FamilyResult result, string toolchain)
    {
        var report = new CheckReport($"GPU compiler, {result.Family.Name}") { SkippedBecause = result.SkippedBecause };
        if (result.SkippedBecause is not null) return report;
        report.Findings.AddRange(result.Problems);
        // What another compiler makes of the same shaders says nothing of the shaders.
        if (toolchain != committed.Programs.Toolchain && result.Problems.Count == 0)
        {
            report.SkippedBecause = $"compiled by {toolchain}, the tables are of {committed.Programs.Toolchain}; --update writes them anew";
            return report;
        }
        var measured = new CompiledTables(toolchain);
        Fill(measured, result);
        report.Figures = Summary(measured, result.Variants);
        Add(report, CompiledTables.ProgramRules, committed.Programs, measured.Programs);
        Add(report, CompiledTables.LoopRules, committed.Loops, measured.Loops);
        if (report.Findings.Count > 0) report.Findings.Add("where this is meant: ./run check --only gpu --update, and say why in the commit");
        return report;
    }

    private static void Add(CheckReport report, IReadOnlyList<FigureRule> rules, FigureTable committed, FigureTable measured)
    {
        var comparison = new TableComparison(rules);
        comparison.Compare(committed, measured);
        report.Findings.AddRange(comparison.Findings);
        report.Notes.AddRange(comparison.Notes);
    }

    private static void Fill(CompiledTables tables, FamilyResult result)
    {
        foreach (var line in result.Programs) tables.Programs.Add(line, result.Family.Name);
        foreach (var line in result.Loops) tables.Loops.Add(line, result.Family.Name);
    }

    private static string Summary(CompiledTables tables, int variants)
    {
        var programs = tables.Programs;
        int Count(string column) => programs.Rows.Keys.Count(key => programs[key, column] > 0);
        var spilling = programs.Rows.Keys.Count(key => programs[key, CompiledTables.Spills] + programs[key, CompiledTables.ScalarSpills] > 0);
        return $"{programs.Rows.Count} programs of {variants} variants, {spilling} spill, {Count(CompiledTables.Scratch)} use scratch memory, "
            + $"{tables.Loops.Rows.Count} hot loops, {programs.Toolchain}";
    }
}
