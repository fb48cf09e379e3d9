using Headless.Shaders;
using System.Diagnostics;

namespace Headless.Mutation.Running;

/// <summary>The kernel variants that tests dispatch: which files they are made of, and what a change makes of their code.</summary>
internal sealed class KernelVariants
{
    private readonly ProjectOverlay overlay;
    private readonly string cache;
    private readonly List<Variant> variants = [];
    private readonly Dictionary<string, byte[]> optimised = new(StringComparer.Ordinal);

    private sealed record Variant(string Label, string Path, string Kernel, string[] Keywords, IReadOnlyCollection<string> Files);

    public KernelVariants(ProjectOverlay overlay, IEnumerable<string> labels, string cache)
    {
        (this.overlay, this.cache) = (overlay, cache);
        var includes = new IncludeResolver(overlay.Project);
        var sources = new Dictionary<string, ComputeSource>(StringComparer.Ordinal);
        foreach (string label in labels.Order(StringComparer.Ordinal))
        {
            string[] parts = label.Split('|');
            string path = parts[0];
            if (!sources.TryGetValue(path, out ComputeSource? source)) sources.Add(path, source = ComputeSource.Parse(System.IO.Path.Combine(overlay.Project, path), includes));
            HashSet<string> files = [.. source.Expanded.Files.Where(f => f.StartsWith("Packages/com.sphfluid/", StringComparison.Ordinal)).Select(f => f["Packages/com.sphfluid/".Length..])];
            variants.Add(new Variant(label, path, parts[1], parts[2].Split(' ', StringSplitOptions.RemoveEmptyEntries), files));
        }
    }

    /// <summary>Shader files of the package that the variants are made of.</summary>
    public IReadOnlyList<string> Files => [.. variants.SelectMany(v => v.Files).Distinct().Order(StringComparer.Ordinal)];

    /// <summary>Variants whose code differs from the unchanged code, after the change was written to the overlay; null when one does not compile.</summary>
    /// <remarks>"Differs" is judged after spirv-opt -O: what an optimiser takes for the same is the same.</remarks>
    public IReadOnlyList<string>? Affected(string file, out string problem)
    {
        problem = "";
        var compiler = new ShaderCompiler(cache, new IncludeResolver(overlay.Project));
        var sources = new Dictionary<string, ComputeSource>(StringComparer.Ordinal);
        List<string> affected = [];
        foreach (Variant variant in variants.Where(v => v.Files.Contains(file)))
        {
            try
            {
                if (!sources.TryGetValue(variant.Path, out ComputeSource? source))
                    sources.Add(variant.Path, source = ComputeSource.Parse(System.IO.Path.Combine(overlay.Project, variant.Path), compiler.Includes));
                byte[] changed = compiler.CompileKernel(source, variant.Kernel, variant.Keywords).SpirV;
                byte[] original = Original(variant);
                if (changed.AsSpan().SequenceEqual(original)) continue;
                if (!optimised.TryGetValue(variant.Label, out byte[]? reference)) optimised.Add(variant.Label, reference = Optimise(original));
                if (!Optimise(changed).AsSpan().SequenceEqual(reference)) affected.Add(variant.Label);
            }
            catch (ShaderCompileException e)
            {
                problem = e.Message;
                return null;
            }
        }
        return affected;
    }

    private readonly Dictionary<string, byte[]> originals = new(StringComparer.Ordinal);
    private ShaderCompiler? original;
    private readonly Dictionary<string, ComputeSource> unchanged = new(StringComparer.Ordinal);

    private byte[] Original(Variant variant)
    {
        if (originals.TryGetValue(variant.Label, out byte[]? code)) return code;
        original ??= new ShaderCompiler(cache, new IncludeResolver(overlay.Source));
        if (!unchanged.TryGetValue(variant.Path, out ComputeSource? source))
            unchanged.Add(variant.Path, source = ComputeSource.Parse(System.IO.Path.Combine(overlay.Source, variant.Path), original.Includes));
        originals.Add(variant.Label, code = original.CompileKernel(source, variant.Kernel, variant.Keywords).SpirV);
        return code;
    }

    private static byte[] Optimise(byte[] code)
    {
        string input = System.IO.Path.GetTempFileName(), output = input + ".opt";
        try
        {
            File.WriteAllBytes(input, code);
            using Process process = Process.Start(new ProcessStartInfo("spirv-opt", ["-O", "--strip-debug", "--scalar-block-layout", input, "-o", output])
            {
                RedirectStandardError = true, RedirectStandardOutput = true,
            })!;
            process.StandardError.ReadToEnd();
            process.WaitForExit();
            return File.Exists(output) ? File.ReadAllBytes(output) : code;
        }
        finally
        {
            File.Delete(input);
            File.Delete(output);
        }
    }
}
