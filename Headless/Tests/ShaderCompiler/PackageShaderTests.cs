using System.Runtime.CompilerServices;
using Headless.Shaders;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

/// <summary>Every kernel and pass of the package becomes valid SPIR-V.</summary>
public sealed class PackageShaderTests : SandboxTests
{
    private static IEnumerable<string> Files() =>
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
                ShaderSandbox.Validate(compiler.CompileKernel(source, kernel.Name, FirstOfEach(source.KeywordSets)));
                ShaderSandbox.Validate(compiler.CompileKernel(source, kernel.Name, LastOfEach(source.KeywordSets)));
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

    private static string[] FirstOfEach(IEnumerable<KeywordSet> sets) => [.. sets.Select(s => s.Keywords[0])];

    private static string[] LastOfEach(IEnumerable<KeywordSet> sets) => [.. sets.Select(s => s.Keywords[^1])];

    private static string Repository([CallerFilePath] string thisFile = "") =>
        Path.GetFullPath(Path.Combine(Path.GetDirectoryName(thisFile)!, "..", "..", ".."));
}
