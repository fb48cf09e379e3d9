using Headless.Files;
using Headless.Player;
using Headless.Shaders;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

/// <summary>Every kernel of the package goes from Direct3D's compiler to valid SPIR-V.</summary>
public sealed class Direct3DPackageTests
{
    private static IEnumerable<string> Files() => PackageShaderTests.Files().Where(f => Path.GetExtension(f) == ".compute");

    [TestCaseSource(nameof(Files))]
    public void Translates(string file)
    {
        Direct3DFrontEnd direct3D = Direct3DTools.Require();
        IncludeResolver includes = new(PackageShaderTests.Root);
        // The player's cache: what a test compiles here, the package's tests do not compile again.
        ShaderCompiler compiler = new(Path.Combine(UserCache.Folder, "shaders"), includes) { Direct3D = direct3D };
        ComputeSource source = ComputeSource.Parse(Path.Combine(PackageShaderTests.Root, file), includes);
        foreach (KernelDeclaration kernel in source.Kernels)
        {
            foreach (string[] keywords in PackageShaderTests.Ends(source.KeywordSets))
            {
                ShaderBinary binary = compiler.CompileKernel(source, kernel.Name, keywords);
                Assert.That(binary.ByDirect3D, Is.True, () => string.Join('\n', direct3D.Untranslated));
                ShaderSandbox.Validate(binary);
            }
        }
    }
}
