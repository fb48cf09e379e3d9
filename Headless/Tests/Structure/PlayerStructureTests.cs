using Headless.Files;
using NUnit.Framework;

namespace Headless.Tests.Structure;

/// <summary>The player plays any Unity project: it knows no package.</summary>
public sealed class PlayerStructureTests
{
    private static readonly string[] kinds = [".c", ".cginc", ".cs", ".csproj", ".hlsl", ".props", ".sh", ".shader"];

    private static string Root => Conformance.ReleaseBuildTests.FindUp("Headless/Play.slnx");

    [TestCase("CommandLine")]
    [TestCase("Importers")]
    [TestCase("Pacing")]
    [TestCase("Player")]
    [TestCase("ShaderCompiler")]
    [TestCase("TestRunner")]
    [TestCase("UnityBurst")]
    [TestCase("UnityEditor")]
    [TestCase("UnityEngine")]
    [TestCase("UnityMathematics")]
    [TestCase("UnityUniversal")]
    [TestCase("Vulkan")]
    public void NoSourceOfThePlayerNamesThePackage(string folder)
    {
        string[] sources = [.. Directory.GetFiles(Path.Combine(Root, "Headless", folder), "*", SearchOption.AllDirectories).Where(f => kinds.Contains(Path.GetExtension(f)))];
        Assert.That(sources, Is.Not.Empty);
        Assert.That(sources.Where(f => File.ReadAllText(f) is var text && (Names(text, "sphfluid") || Names(text, "$(PackageRoot)") || Names(text, "$(ValidationRoot)"))), Is.Empty);
    }

    [TestCase("setup.sh", "/.cache}/NAME\n")]
    [TestCase(".github/workflows/test.yml", " ~/.cache/NAME\n")]
    public void ScriptsNameThePlayersCache(string file, string line) =>
        Assert.That(File.ReadAllText(Path.Combine(Root, file)).ReplaceLineEndings("\n"), Does.Contain(line.Replace("NAME", Path.GetFileName(UserCache.Folder))));

    private static bool Names(string text, string name) => text.Contains(name, StringComparison.OrdinalIgnoreCase);
}
