using Headless.Shaders;

namespace Headless.Checks.Shaders;

/// <summary>
/// Finds kernels in which a branch or the end of a loop hangs on uniforms alone. Lavapipe, which draws on machines without a graphics card,
/// writes the values of such uniforms into the kernel and may translate it anew at every dispatch (Mesa 22.3's lvp_inline_uniforms.c and update_inline_shader_state):
/// contacts with triangles took 42 ms a step in place of 2.4, the thesis's accelerations 4.9 in place of 0.3.
/// </summary>
internal sealed class UniformBranchCheck(ProjectPackages packages, string shaderCache)
{
    private const string NothingGained =
        "measured with 512 particles, llvmpipe, Mesa 22.3.6, 2026-11-22: no dispatch got faster when a varying value was mixed in";

    private const string NothingGainedFused =
        "measured with 8,192 particles, llvmpipe, Mesa 22.3.6, 2026-11-25: the sort got no faster when a varying value was mixed in";


    /// <summary>Kernel and uniforms, with the reason why the branch stays.</summary>
    private const string Paired = "of two values; paired frames of llvmpipe take as long as with a value of a buffer mixed in: 0.98 and 0.95 of the time in Dam Break, 2026-11-27";

    private static readonly Dictionary<string, string> known = new(StringComparer.Ordinal)
    {
        ["*: _KeepsOrder"] = Paired,
        ["*: _Drains"] = Paired,
        ["BitonicSort: _Level"] = NothingGained,
        ["FusedBitonicSort: _FirstLevel _LastLevel"] = NothingGainedFused,
        ["FusedBitonicSort: _FirstLevel _LastDistance"] = NothingGainedFused,
        ["PlaceWallPatches: _BeginsPart"] = "a thread for each rectangle: a few in a scene",
        ["CarryWallPatches: _BeginsPart"] = "a thread for each rectangle: a few in a scene",
        ["BeginSurfaceRound: _LateRound"] = "a single thread of a few instructions; Mesa leaves kernels of 100 values or fewer alone",
        ["ScanWhitewater: _GroupTotal"] = "a loop of two turns for 65,536 particles and as many of whitewater; the number changes only with the liquid",
        ["ScanSpray: _GroupTotal"] = "a loop of one turn for 65,536 particles; the number changes only with the liquid",
        ["SetMCGridDensityFactors: _MCWallCompletion"] = "once a frame, and the frame's work of a second hides a translation of milliseconds",
    };

    public CheckReport Run()
    {
        var report = new CheckReport("Branches on uniforms alone");
        var includes = new IncludeResolver(packages.Project);
        var compiler = new ShaderCompiler(shaderCache, includes);
        var kernels = ShaderVariants.Read(packages, includes, report.Findings).Where(v => v.IsKernel).ToList();
        try { compiler.Prewarm(kernels.Select(v => v.Request)); }
        catch (ShaderCompileException e) { report.Findings.Add(e.Message); }
        catch (ShaderCompilerMissingException e) { report.SkippedBecause = e.Message; }
        if (report.Findings.Count > 0 || report.SkippedBecause is not null) return report;
        var used = new HashSet<string>();
        foreach (var kernel in kernels.DistinctBy(k => k.Name))
        {
            var branches = UniformBranches.Find(kernel.Compile(compiler)[0].SpirV);
            used.UnionWith(branches.Select(b => Key(kernel, b)).Where(known.ContainsKey));
            if (branches.Any(b => !known.ContainsKey(Key(kernel, b)))) Report(compiler, kernel, report);
        }
        foreach (var unused in known.Keys.Except(used)) report.Findings.Add($"no kernel has the branch '{unused}' any more: take it off the list of {nameof(UniformBranchCheck)}");
        report.Figures = $"{kernels.Count} kernel variants, {used.Count} branches that stay for a reason";
        if (report.Findings.Count > 0) report.Findings.Add("mix in a value of a buffer, use a keyword, or list the branch with the reason in UniformBranchCheck.cs");
        return report;
    }

    private static void Report(ShaderCompiler compiler, ShaderVariant kernel, CheckReport report)
    {
        foreach (var branch in UniformBranches.Find(compiler.CompileWithLines(kernel.Request, out var lineOf)).Distinct())
        {
            if (known.ContainsKey(Key(kernel, branch))) continue;
            var (file, line) = lineOf(branch.Line);
            report.Findings.Add($"{kernel.Name}: {(branch.EndsLoop ? "the end of a loop" : "a branch")} hangs on {branch.Uniforms} alone, {Path.GetFileName(file)}({line})");
        }
    }

    // As listed for all kernels, or for one.
    private static string Key(ShaderVariant kernel, UniformBranch branch) =>
        known.ContainsKey($"*: {branch.Uniforms}") ? $"*: {branch.Uniforms}" : $"{kernel.Entry}: {branch.Uniforms}";
}
