using Headless.Checks.Api;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using NUnit.Framework;

namespace Headless.Tests.Checks;

/// <summary>A stand-in of the Universal Render Pipeline with one property, as the check sees it.</summary>
public sealed class StandInSurfaceCheckTests
{
    private const string Assembly = "Unity.RenderPipelines.Universal.Runtime";

    private string folder = "";

    [SetUp]
    public void MakeFolder() => folder = Directory.CreateTempSubdirectory("surface-").FullName;

    [TearDown]
    public void Delete() => Directory.Delete(folder, recursive: true);

    [TestCase("UniversalRendererData", "depthPrimingMode", 2, 2)]
    [TestCase("UniversalRenderPipelineAsset", "allowPostProcessAlphaOutput", 1, 2)]
    [TestCase("UniversalRenderPipelineAsset", "enableRenderGraph", 1, 1)]
    public void WhatUniversal17HasPasses(string type, string property, int in14, int in175)
    {
        var report = Check(type, property);
        Assert.That(report.Findings, Is.Empty);
        Assert.That(report.Figures, Does.EndWith($"2 of the render pipelines in 6000.0, of which {in14} in 2022.3, {in175} in 6000.5"));
    }

    [TestCase("tileOnlyMode", TestName = "of 17.5 alone")]
    [TestCase("noSuchThing", TestName = "of none")]
    public void WhatItHasNotIsFound(string property) => Assert.That(Check("UniversalRendererData", property).Findings,
        Is.EqualTo(new[] { $"P:UnityEngine.Rendering.Universal.UniversalRendererData.{property} is not in Unity 6000.0" }));

    private Headless.Checks.CheckReport Check(string type, string property)
    {
        string source = $"namespace UnityEngine.Rendering.Universal; public class {type} {{ public int {property} => 0; }}";
        MetadataReference core = MetadataReference.CreateFromFile(typeof(object).Assembly.Location);
        Assert.That(CSharpCompilation.Create(Assembly, [CSharpSyntaxTree.ParseText(source)], [core], new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary))
            .Emit(Path.Combine(folder, Assembly + ".dll")).Success);
        return new StandInSurfaceCheck(folder).Run();
    }
}
