using Headless.Checks.Fxc;
using Headless.Shaders;

namespace Headless.Checks.Shaders;

/// <summary>Every kernel and pass that the packages ship, in every choice of keywords, in the order of their names; tests' shaders are
/// left out.</summary>
internal static class ShaderVariants
{
    private const string Tests = "/Tests/";

    /// <param name="problems">Files that cannot be read, one message each.</param>
    public static List<ShaderVariant> Read(ProjectPackages packages, IncludeResolver includes, List<string> problems)
    {
        var variants = new List<ShaderVariant>();
        foreach (var path in packages.Files())
        {
            if (("/" + packages.PathInPackage(path)).Contains(Tests, StringComparison.Ordinal)) continue;
            var file = packages.NameOf(path);
            try
            {
                if (path.EndsWith(".compute", StringComparison.Ordinal))
                    variants.AddRange(OfCompute(file, ComputeSource.Parse(path, includes)));
                else if (path.EndsWith(".shader", StringComparison.Ordinal))
                    variants.AddRange(OfShader(file, ShaderLabSource.Parse(path, includes)));
            }
            catch (ShaderCompileException e) { problems.Add(e.Message); }
        }
        return [.. variants.OrderBy(v => v.Name, StringComparer.Ordinal)];
    }

    private static IEnumerable<ShaderVariant> OfCompute(string file, ComputeSource source) =>
        from kernel in source.Kernels
        from keywords in FxcJob.Variants(source.KeywordSets)
        select new ShaderVariant(file, kernel.Name, string.Join(' ', keywords), new ShaderRequest(source, kernel.Name, keywords));

    private static IEnumerable<ShaderVariant> OfShader(string file, ShaderLabSource shader) =>
        from sub in shader.SubShaders.Select((value, index) => (value, index))
        from pass in sub.value.Passes.Select((value, index) => (value, index))
        from keywords in FxcJob.Variants(pass.value.Program.KeywordSets)
        where !keywords.Contains("STEREO_INSTANCING_ON") // the same work with another eye's matrices
        let entry = $"{sub.index}.{pass.index} {pass.value.Name}".Trim()
        select new ShaderVariant(file, entry, string.Join(' ', keywords), new ShaderRequest(pass.value, keywords));
}
