using Headless.Checks.Gpu;
using Headless.Checks.Shaders;
using Headless.Shaders;

namespace Headless.Checks.Buffers;

/// <summary>
/// Counts the storage buffers of every stage as it is compiled and holds them against a committed table, and the manual's table by part
/// against the same count. WebGPU promises 8 a stage, and browsers give 10.
/// </summary>
/// <param name="tableFolder">Where the table is.</param>
internal sealed class BufferCheck(ProjectPackages packages, string shaderCache, string tableFolder)
{
    public const string Buffers = "buffers", Written = "written";

    private const string About = "storage buffers that each compiled stage uses; ./run check --only buffers --update";
    private const int WebGpuPromised = 8, WebGpuUsual = 10;

    private static readonly string[] key = ["file", "entry", "keywords", "stage"];
    private static readonly string[] columns = [Buffers, Written];
    private static readonly FigureRule[] rules = [new(Buffers, Fails: true), new(Written, Fails: true)];

    private string TableFile => Path.Combine(tableFolder, "buffers.csv");
    private BufferPage Page => new(Path.Combine(packages.Product, "Documentation~", "platforms.md"));

    /// <param name="update">Writes the tables anew in place of holding the count against them.</param>
    public CheckReport Run(bool update)
    {
        var report = new CheckReport("Storage buffers a stage");
        try
        {
            var counted = Count(report);
            if (counted.Count == 0 && report.Findings.Count == 0) report.Findings.Add($"no shaders below {packages.Folder}");
            if (report.Findings.Count > 0) return report;
            Hold(counted, update, report);
        }
        catch (ShaderCompileException e) { report.Findings.Add(e.Message); }
        catch (ShaderCompilerMissingException e) { report.SkippedBecause = e.Message; }
        catch (FormatException e) { report.Findings.Add(e.Message); }
        return report;
    }

    private List<(ShaderVariant Variant, StageBuffers Stage)> Count(CheckReport report)
    {
        var includes = new IncludeResolver(packages.Project);
        var compiler = new ShaderCompiler(shaderCache, includes);
        var variants = ShaderVariants.Read(packages, includes, report.Findings);
        if (report.Findings.Count > 0) return [];
        compiler.Prewarm(variants.Select(v => v.Request));
        return [.. variants.SelectMany(v => v.Compile(compiler).Select(binary => (v, StageBuffers.Of(binary))))];
    }

    private void Hold(List<(ShaderVariant Variant, StageBuffers Stage)> counted, bool update, CheckReport report)
    {
        var table = new FigureTable(About, key, columns);
        foreach (var (variant, stage) in counted.Where(c => c.Stage.Count > 0))
            table.Rows.TryAdd($"{variant.File},{variant.Entry},{variant.Keywords},{stage.Stage}", [stage.Count, stage.Written]);
        var rows = Parts(counted).ToList();
        if (update)
        {
            table.Write(TableFile);
            Page.Write(rows);
        }
        else if (!File.Exists(TableFile)) report.Findings.Add($"no table {TableFile}");
        else
        {
            var comparison = new TableComparison(rules);
            comparison.Compare(FigureTable.Read(TableFile, key, columns), table);
            report.Findings.AddRange(comparison.Findings);
        }
        report.Findings.AddRange(Page.Compare(rows));
        report.Figures = $"{table.Rows.Count} stages with buffers{Above(counted, WebGpuPromised)}{Above(counted, WebGpuUsual)}";
        if (report.Findings.Count > 0 && !update) report.Findings.Add("where this is meant: ./run check --only buffers --update, and say why in the commit");
    }

    private static string Above(List<(ShaderVariant Variant, StageBuffers Stage)> counted, int limit) =>
        $"; {counted.Where(c => c.Stage.Count > limit).Select(c => (c.Variant.File, c.Variant.Entry)).Distinct().Count()} shaders with more than {limit} in one";

    /// <summary>Of each part the stage with most.</summary>
    private static IEnumerable<string> Parts(List<(ShaderVariant Variant, StageBuffers Stage)> counted)
    {
        foreach (var part in counted.GroupBy(c => BufferPart.Of(c.Variant)).OrderBy(p => BufferPart.All.TakeWhile(q => q != p.Key).Count()))
        {
            var most = part.MaxBy(c => c.Stage.Count);
            yield return BufferPage.Row(part.Key.Name, most.Stage.Count, part.Max(c => c.Stage.Written), ShaderName(most.Variant));
        }
    }

    private static string ShaderName(ShaderVariant variant) => variant.IsKernel ? variant.Entry : Path.GetFileNameWithoutExtension(variant.File);
}
