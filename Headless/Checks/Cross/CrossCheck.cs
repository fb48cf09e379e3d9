using Headless.Checks.Shaders;
using Headless.Shaders;

namespace Headless.Checks.Cross;

/// <summary>Translates every kernel into the languages of Metal and of OpenGL ES 3.1, and says which need more than every such device has.</summary>
internal sealed class CrossCheck(ProjectPackages packages, string shaderCache)
{
    // OpenGL ES 3.1, table 20.45: what every device has at least.
    private const int EsslStorageBlocks = 4, EsslThreads = 128, EsslSharedBytes = 16384;

    // Metal Feature Set Tables: buffers of a compute function, threadgroup memory of Apple's first four families, threads of any.
    private const int MetalBuffers = 31, MetalSharedBytes = 16384, MetalThreads = 512;

    public IEnumerable<CheckReport> Run()
    {
        CheckReport metal = new("Metal, by spirv-cross"), essl = new("OpenGL ES 3.1, by spirv-cross");
        if (Tool.Run("spirv-cross", "--help") is null)
        {
            metal.SkippedBecause = essl.SkippedBecause = "spirv-cross is not installed: apt-get install spirv-cross";
            return [metal, essl];
        }
        var includes = new IncludeResolver(packages.Project);
        var compiler = new ShaderCompiler(shaderCache, includes);
        var kernels = new List<CrossKernel>();
        foreach (var variant in ShaderVariants.Read(packages, includes, metal.Findings).Where(v => v.IsKernel))
        {
            try { kernels.Add(new CrossKernel(variant, variant.Compile(compiler)[0])); }
            catch (ShaderCompileException e) { metal.Findings.Add(e.Message); }
        }
        if (kernels.Count == 0 && metal.Findings.Count == 0) metal.Findings.Add($"no kernels below {packages.Folder}");
        Translate(kernels, metal, essl);
        metal.Figures = $"{kernels.Count} kernels and variants translated" + Above(metal, kernels, "buffers", k => k.Buffers, MetalBuffers)
            + Above(kernels, "threads a group", k => k.Threads, MetalThreads) + Above(kernels, "bytes of groupshared memory", k => k.SharedBytes, MetalSharedBytes);
        essl.Figures = $"{kernels.Count} kernels and variants translated, and compiled by glslangValidator"
            + Above(essl, kernels, "storage buffers", k => k.StorageBuffers, EsslStorageBlocks)
            + Above(kernels, "threads a group", k => k.Threads, EsslThreads) + Above(kernels, "bytes of groupshared memory", k => k.SharedBytes, EsslSharedBytes);
        return [metal, essl];
    }

    private static void Translate(List<CrossKernel> kernels, CheckReport metal, CheckReport essl)
    {
        var folder = Directory.CreateTempSubdirectory("cross");
        try
        {
            var problems = kernels.AsParallel().AsOrdered()
                .Select(k => (k.Variant.Name, Metal: k.ToMetal(folder.FullName), Essl: k.ToEssl(folder.FullName))).ToList();
            metal.Findings.AddRange(problems.Where(p => p.Metal is not null).Select(p => $"{p.Name}: {p.Metal}"));
            essl.Findings.AddRange(problems.Where(p => p.Essl is not null).Select(p => $"{p.Name}: {p.Essl}"));
        }
        finally { folder.Delete(recursive: true); }
    }

    // "; 3 kernels have more than 128 threads a group", with a note for each where the report is given.
    private static string Above(CheckReport report, List<CrossKernel> kernels, string what, Func<CrossKernel, int> needed, int guaranteed)
    {
        report.Notes.AddRange(OfEach(kernels, needed).Where(k => needed(k) > guaranteed)
            .Select(k => $"{k.Variant.File} {k.Variant.Entry}: {needed(k)} {what}, every device has {guaranteed}"));
        return Above(kernels, what, needed, guaranteed);
    }

    private static string Above(List<CrossKernel> kernels, string what, Func<CrossKernel, int> needed, int guaranteed)
    {
        var count = OfEach(kernels, needed).Count(k => needed(k) > guaranteed);
        return count > 0 ? $"; {count} have more than {guaranteed} {what}" : "";
    }

    /// <summary>Of each kernel the variant that needs most.</summary>
    private static IEnumerable<CrossKernel> OfEach(List<CrossKernel> kernels, Func<CrossKernel, int> needed) =>
        kernels.GroupBy(k => (k.Variant.File, k.Variant.Entry)).Select(variants => variants.MaxBy(needed)!);
}
