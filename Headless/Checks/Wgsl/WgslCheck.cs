using Headless.Checks.Shaders;
using Headless.Shaders;

namespace Headless.Checks.Wgsl;

/// <summary>
/// Translates every kernel and drawing stage into WebGPU's language by naga (wgpu's translator) and gives that to Dawn, Chrome's WebGPU,
/// without a device: its compiler and the limits that every device has.
/// </summary>
internal sealed class WgslCheck(ProjectPackages packages, string shaderCache, string cacheFolder)
{
    private const string Driver = "wgsl.mjs", Node = "node";

    private static readonly string[] tools = ["naga.mjs", "naga_bg.wasm", "dawn.node"];

    /// <summary>What WGSL, or naga, does not have: shader and stage, with the reason.</summary>
    private static readonly Dictionary<string, string> known = new(StringComparer.Ordinal)
    {
        ["Thesis/Shaders/Surface/FluidSurfaceGeometry.shader Geometry"] = "WebGPU has no geometry shaders",
        ["Thesis/Shaders/Surface/FluidSurfaceGeometry.shader Vertex"] = "what it passes to the geometry stage is no interface of WGSL",
        ["Shaders/Surface/Sparse/SampleBlocks.compute Compute"] = "WGSL wants barriers where all threads of a group surely come, and the loop over candidates ends by a number in groupshared memory",
        ["Shaders/Surface/Sparse/CountBlocks.compute Compute"] = "naga 30.0.1 loses a value that is made before a loop's end and used behind it",
        ["Shaders/Rendering/ShadowConstants.shader Fragment"] = "naga 30.0.1 does not read a load from a vector at a remainder",
    };

    private sealed record Job(ShaderVariant Variant, ShaderBinary Binary)
    {
        public string Name => $"{Variant.File} {Variant.Entry}{(Variant.Keywords.Length > 0 ? $" [{Variant.Keywords}]" : "")} {Binary.Stage}";
        public string Key => $"{Variant.File} {Binary.Stage}";
    }

    private sealed record Result(Job Job, string Outcome, string Message);

    public CheckReport Run()
    {
        var report = new CheckReport("WGSL, by naga and Dawn");
        report.SkippedBecause = tools.FirstOrDefault(t => !File.Exists(Path.Combine(cacheFolder, t))) is { } missing
            ? $"{missing} is not in {cacheFolder}: run './setup.sh test' with a network"
            : Tool.Run(Node, "--version") is null ? "node is not installed: apt-get install nodejs" : null;
        if (report.SkippedBecause is not null) return report;
        try
        {
            var jobs = Jobs(report);
            if (jobs.Count == 0 && report.Findings.Count == 0) report.Findings.Add($"no shaders below {packages.Folder}");
            if (report.Findings.Count == 0) Judge(Translate(jobs, report), jobs.Count, report);
        }
        catch (ShaderCompileException e) { report.Findings.Add(e.Message); }
        catch (ShaderCompilerMissingException e) { report.SkippedBecause = e.Message; }
        return report;
    }

    private List<Job> Jobs(CheckReport report)
    {
        var includes = new IncludeResolver(packages.Project);
        var compiler = new ShaderCompiler(shaderCache, includes);
        var variants = ShaderVariants.Read(packages, includes, report.Findings);
        compiler.Prewarm(variants.Select(v => v.Request));
        return [.. variants.SelectMany(v => v.Compile(compiler).Select(binary => new Job(v, binary)))];
    }

    // WGSL has no words for D3D's packing (a float3 of 12 bytes in an array); the code is the same in the layout of GLSL.
    private List<Result> Translate(List<Job> jobs, CheckReport report)
    {
        var results = Run([.. jobs.Select(j => (j, j.Binary.SpirV))], report);
        var packed = results.Where(IsPacking).Select(r => r.Job).ToList();
        var again = packed.AsParallel().AsOrdered().Select(j => (j, j.Variant.CompileInGlslLayout(j.Binary.Stage, j.Binary.EntryPoint))).ToList();
        return [.. results.Where(r => !IsPacking(r)), .. Run(again, report)];
    }

    private static bool IsPacking(Result result) => result.Outcome == "naga" && result.Message.Contains("Alignment requirements", StringComparison.Ordinal);

    private List<Result> Run(IReadOnlyList<(Job Job, byte[] SpirV)> jobs, CheckReport report)
    {
        var folder = Directory.CreateTempSubdirectory("wgsl");
        try
        {
            for (var i = 0; i < jobs.Count; i++) File.WriteAllBytes(Path.Combine(folder.FullName, $"{i}.spv"), NagaForm.Of(jobs[i].SpirV, jobs[i].Job.Binary.Stage));
            var script = Path.Combine(folder.FullName, Driver);
            using (var source = typeof(WgslCheck).Assembly.GetManifestResourceStream(Driver)!)
            using (var target = File.Create(script)) source.CopyTo(target);
            var (code, output) = Tool.Run(Node, script, cacheFolder, folder.FullName)!.Value;
            var lines = output.Split('\n').Select(line => line.Split('\t')).Where(fields => fields.Length > 1).ToList();
            if (code != 0 || lines.Count != jobs.Count) report.Findings.Add($"{jobs.Count} stages went in, {lines.Count} came out: {output[^Math.Min(output.Length, 500)..]}");
            return [.. lines.Where(_ => code == 0).Select(f => new Result(jobs[int.Parse(f[0])].Job, f[1], f.Length > 2 ? f[2] : ""))];
        }
        finally { folder.Delete(recursive: true); }
    }

    private static void Judge(List<Result> results, int stages, CheckReport report)
    {
        var failed = results.Where(r => r.Outcome is "naga" or "tint").ToList();
        report.Findings.AddRange(failed.Where(r => !known.ContainsKey(r.Job.Key)).Select(r => $"{r.Job.Name}: {r.Outcome}: {r.Message}"));
        var present = results.Select(r => r.Job.Key).ToHashSet();
        report.Findings.AddRange(known.Keys.Where(present.Contains).Except(failed.Select(r => r.Job.Key))
            .Select(key => $"{key} is translated now: take it off the list of {nameof(WgslCheck)}"));
        var refused = results.Where(r => r.Outcome == "limit").ToList();
        report.Notes.AddRange(refused.GroupBy(r => (r.Job.Variant.File, r.Job.Variant.Entry))
            .Select(g => $"{g.Key.File} {g.Key.Entry}: {g.Count()} of its variants are beyond what every device has: {g.MaxBy(r => r.Message.Length)!.Message}"));
        report.Figures = $"{results.Count(r => r.Outcome == "ok")} of {stages} stages and variants taken by Dawn, {refused.Count} beyond the limits of every device, "
            + $"{failed.Count(r => known.ContainsKey(r.Job.Key))} that WGSL or naga does not have";
    }
}
