using Headless.Checks.Form;
using NUnit.Framework;

namespace Headless.Tests.Checks;

public sealed class FormCheckTests
{
    private const string Guid = "0123456789abcdef0123456789abcdef";
    private const string Other = "fedcba9876543210fedcba9876543210";

    private TemporaryPackage package = null!;

    [SetUp]
    public void MakePackage()
    {
        package = new TemporaryPackage();
        package.WriteMeta("Runtime", Guid).WriteMeta("Runtime/A.asmdef", Other);
    }

    [TearDown]
    public void RemovePackage() => package.Dispose();

    [Test]
    public void CompleteMetasPass() => Assert.That(Metas(), Is.Empty);

    [Test]
    public void AMissingMetaIsFound()
    {
        package.Write("Runtime/B.cs", "");

        Assert.That(Metas(), Has.One.Contains("B.cs has no .meta"));
    }

    [Test]
    public void ALeftOverMetaIsFound()
    {
        package.WriteMeta("Runtime/Gone.cs", "00000000000000000000000000000001");

        Assert.That(Metas(), Has.One.Contains("Gone.cs.meta belongs to nothing"));
    }

    [Test]
    public void ASharedGuidIsFound()
    {
        package.Write("Runtime/B.cs", "").WriteMeta("Runtime/B.cs", Guid);

        Assert.That(Metas(), Has.One.Contains("have the same GUID"));
    }

    [Test]
    public void ADanglingReferenceIsFound()
    {
        package.Write("Samples~/S/S.unity", "  m_Script: {fileID: 11500000, guid: 11111111111111111111111111111111, type: 3}\n")
            .WriteMeta("Samples~/S", "00000000000000000000000000000002").WriteMeta("Samples~/S/S.unity", "00000000000000000000000000000003");

        Assert.That(Metas(), Has.One.Contains("11111111111111111111111111111111"));
    }

    // Unity's own script of Universal's asset, and an asset that is nowhere.
    [Test]
    public void SettingsReferToAssetsOfTheProjectAndOfUnitysPackages()
    {
        package.Write("../../ProjectSettings/GraphicsSettings.asset", $$"""
              m_CustomRenderPipeline: {fileID: 11400000, guid: {{Guid}}, type: 2}
              m_Script: {fileID: 11500000, guid: bf2edee5c58d82540a51f03df9d42094, type: 3}
              m_Shader: {fileID: 4800000, guid: 11111111111111111111111111111111, type: 3}
            """);

        Assert.That(Metas(), Is.EqualTo(new[] { "ProjectSettings/GraphicsSettings.asset refers to 11111111111111111111111111111111, which no asset has" }));
    }

    [Test]
    public void ManifestFaultsAreFound()
    {
        package.Write("package.json", """{ "name": "com.sphfluid", "version": "1.0", "unity": "2021.3", "samples": [ { "path": "Samples~/Nowhere" } ] }""")
            .Write("CHANGELOG.md", "## [0.9.0]").Write("Samples~/Unlisted/a.txt", "");

        var findings = new PackageManifestCheck(package.Root).Run().Findings;

        Assert.That(findings, Has.Some.Contains("'1.0' is not a semantic version"));
        Assert.That(findings, Has.Some.Contains("2022.3"));
        Assert.That(findings, Has.Some.Contains("## [1.0]"));
        Assert.That(findings, Has.Some.Contains("Samples~/Nowhere"));
        Assert.That(findings, Has.Some.Contains("Samples~/Unlisted"));
        Assert.That(findings, Has.Some.Contains("README.md is missing"));
    }

    [TestCase("## [1.2.0] - 2026-11-27\n## [1.1.0] - 2026-01-01\n", true)]
    [TestCase("## [1.2.0] - unreleased\n", true)]
    [TestCase("## [1.2.0]\n", false)]
    [TestCase("## [1.3.0] - unreleased\n## [1.2.0] - 2026-11-27\n", false)]
    public void TheChangelogBeginsWithTheVersion(string text, bool begins)
    {
        package.Write("package.json", """{ "version": "1.2.0" }""").Write("CHANGELOG.md", text);

        Assert.That(new PackageManifestCheck(package.Root).Run().Findings, begins ? Has.None.Contains("CHANGELOG.md begins") : Has.One.Contains("CHANGELOG.md begins"));
    }

    [Test]
    public void PackagesHaveOneVersion()
    {
        package.Write("package.json", """{ "version": "1.2.0" }""").Write("../b/package.json", """{ "version": "1.1.0" }""");

        Assert.That(new ProjectSettingsCheck(package.Packages).Run().Findings, Has.One.EqualTo("b has version 1.1.0, com.sphfluid 1.2.0"));
    }

    [Test]
    public void AFieldWithoutATooltipIsFound()
    {
        package.Write("Runtime/A.cs", """
            class A : MonoBehaviour
            {
                [SerializeField] float bare;
                [SerializeField, Tooltip("words")] float documented;
                [SerializeField, HideInInspector] float hidden;
                float own;
            }
            """);

        Assert.That(new SerializedFieldCheck(package.Packages).Run().Findings, Is.EqualTo(new[] { "A.cs: A.bare has no [Tooltip]" }));
    }

    [TestCase("#if defined(SHADER_API_D3D11) || defined(SHADER_API_METAL)", 2)]
    [TestCase("#ifdef SHADER_API_VULKAN", 1)]
    [TestCase("#if defined(SHADER_API_GLES3) || \\\n    defined(SHADER_API_SWITCH)", 1)]
    [TestCase("#if !defined(SHADER_API_GLCORE) && !defined(SHADER_API_GLES3) && !defined(SHADER_API_GLES)", 0)]
    [TestCase("// #if defined(SHADER_API_METAL)", 0)]
    public void AListOfGraphicsApisInAShaderIsFound(string line, int findings)
    {
        package.Write("Shaders/A.hlsl", line + "\n#endif\n");

        Assert.That(new ShaderApiCheck(package.Packages).Run().Findings, Has.Count.EqualTo(findings));
    }

    private List<string> Metas() => new MetaFileCheck(package.Packages).Run().Findings;
}
