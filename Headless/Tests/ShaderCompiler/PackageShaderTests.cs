using System.Runtime.CompilerServices;
using Headless.Shaders;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

/// <summary>Every kernel and pass of the package becomes valid SPIR-V.</summary>
public sealed class PackageShaderTests : SandboxTests
{
    internal static IEnumerable<string> Files() =>
        Directory.EnumerateFiles(Path.Combine(Repository(), "Packages"), "*.*", SearchOption.AllDirectories)
            .Where(f => Path.GetExtension(f) is ".compute" or ".shader")
            .Select(f => Path.GetRelativePath(Repository(), f)).Order(StringComparer.Ordinal);

    [TestCaseSource(nameof(Files))]
    public void Compiles(string file)
    {
        IncludeResolver includes = new(Repository());
        ShaderCompiler compiler = new(Sandbox.Cache, includes);
        string path = Path.Combine(Repository(), file);
        if (Path.GetExtension(file) == ".compute")
        {
            ComputeSource source = ComputeSource.Parse(path, includes);
            foreach (KernelDeclaration kernel in source.Kernels)
            {
                foreach (string[] keywords in Ends(source.KeywordSets))
                {
                    ShaderSandbox.Validate(compiler.CompileKernel(source, kernel.Name, keywords));
                }
            }
            return;
        }
        foreach (ShaderPass pass in ShaderLabSource.Parse(path, includes).SubShaders.SelectMany(s => s.Passes))
        {
            foreach (ShaderBinary stage in compiler.CompilePass(pass, LastOfEach(pass.Program.KeywordSets)))
            {
                ShaderSandbox.Validate(stage);
            }
        }
    }

    /// <summary>The first keyword of every set, and the last of every set.</summary>
    internal static IEnumerable<string[]> Ends(IReadOnlyList<KeywordSet> sets) =>
        sets.Count == 0 ? [[]] : [FirstOfEach(sets), LastOfEach(sets)];

    private static string[] FirstOfEach(IEnumerable<KeywordSet> sets) => [.. sets.Select(s => s.Keywords[0])];

    private static string[] LastOfEach(IEnumerable<KeywordSet> sets) => [.. sets.Select(s => s.Keywords[^1])];

    /// <summary>Folder of the repository that these tests are compiled from.</summary>
    internal static string Root => Repository();

    private static string Repository([CallerFilePath] string thisFile = "") =>
        Path.GetFullPath(Path.Combine(Path.GetDirectoryName(thisFile)!, "..", "..", ".."));
}
