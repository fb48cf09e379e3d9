using Headless.Importers;
using Headless.Player;
using Headless.Shaders;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Headless.Tests.Importers;

/// <summary>A project of the Universal Render Pipeline: its settings, its assets and the components that it puts on cameras and lights.</summary>
public sealed class RenderPipelineTests : SceneFixture
{
    private const string AssetScript = "bf2edee5c58d82540a51f03df9d42094", RendererScript = "de640fe3d0db1804a85f9fc8f5cadab6";
    private const string CameraScript = "a79441f348de89743a2939f4d699eac1", LightScript = "474bcb49853aa07438625e644c072ee6";
    private const string VolumeScript = "172515602e62fb746b5d573b38a5fe58", AmbientOcclusionScript = "f62c9c65cf3354c93be831c8bc075510";

    [TearDown]
    public void LeavePipeline() => PipelineChoice.Apply(PipelineChoice.BuiltIn);

    [Test]
    public void SettingsNameTheAssetsByGuid()
    {
        string asset = AddPipeline("Pipeline"), level = AddPipeline("Level");
        Graphics(asset);
        Quality(1, "{fileID: 0}", Reference(level));
        Open();
        Assert.That(GraphicsSettings.defaultRenderPipeline!.name, Is.EqualTo("Pipeline"));
        Assert.That(QualitySettings.renderPipeline!.name, Is.EqualTo("Level"));
        Assert.That(GraphicsSettings.defaultRenderPipeline, Is.InstanceOf<UniversalRenderPipelineAsset>());
        Assert.That(((UniversalRenderPipelineAsset)QualitySettings.renderPipeline).rendererDataList[0], Is.InstanceOf<UniversalRendererData>());
        Assert.That(Reports, Is.Empty);
    }

    [Test]
    public void AProjectWithoutThemIsBuiltIn()
    {
        Graphics(AddPipeline("Pipeline"));
        Quality(0, "{fileID: 0}");
        Open();
        File.Delete(Path.Combine(Project.Root, "ProjectSettings/GraphicsSettings.asset"));
        Open();
        Assert.That((GraphicsSettings.defaultRenderPipeline, QualitySettings.renderPipeline), Is.EqualTo(((RenderPipelineAsset?)null, (RenderPipelineAsset?)null)));
        Assert.That(Reports, Is.Empty);
    }

    [Test]
    public void AnAssetThatIsMissingIsNamed()
    {
        Graphics(new string('7', 32));
        Open();
        Assert.That(GraphicsSettings.defaultRenderPipeline, Is.Null);
        Assert.That(Reports, Has.Count.EqualTo(1).And.All.Contains("GraphicsSettings.asset:5: m_CustomRenderPipeline: no asset has the GUID 7777"));
    }

    [Test]
    public void APipelineWithoutAStandInIsNamed()
    {
        Graphics(Project.Add("Assets/High.asset", Asset("0cf1dab834d4ec34195b920ea7bbf9ec", "High")));
        Open();
        Assert.That(GraphicsSettings.defaultRenderPipeline, Is.Null);
        Assert.That(Reports, Has.Count.EqualTo(1).And.All.Contains("UnityEngine.Rendering.HighDefinition.HDRenderPipelineAsset has no stand-in"));
    }

    [Test]
    public void CamerasAndLightsHaveTheirComponents()
    {
        PlayScene(Thing(1, "Eye", "--- !u!20 &31\nCamera:\n  m_GameObject: {fileID: 1}\n" + Component(41, 1, CameraScript))
            + Thing(2, "Sun", "--- !u!108 &32\nLight:\n  m_GameObject: {fileID: 2}\n" + Component(42, 2, LightScript)));
        Assert.That(GameObject.Find("Eye").GetComponent<UniversalAdditionalCameraData>(), Is.Not.Null);
        Assert.That(GameObject.Find("Sun").GetComponent<UniversalAdditionalLightData>(), Is.Not.Null);
        Assert.That(Reports, Is.Empty);
    }

    [Test]
    public void AClassWithoutAStandInIsReportedOnce()
    {
        PlayScene(Thing(1, "Global", Component(41, 1, VolumeScript)) + Thing(2, "Local", Component(42, 2, VolumeScript)));
        Assert.That(Reports, Is.EqualTo(new[] { "Assets/Main.unity: MonoBehaviour of 'Global': Unity's class UnityEngine.Rendering.Volume has no stand-in; its objects are left out." }));
    }

    [Test]
    public void ARendererFeatureWithoutAStandInIsLeftOut()
    {
        string feature = $"--- !u!114 &-77\nMonoBehaviour:\n  m_Script: {{fileID: 11500000, guid: {AmbientOcclusionScript}, type: 3}}\n  m_Name: SSAO\n";
        string renderer = Project.Add("Assets/Renderer.asset", Asset(RendererScript, "Renderer") + "  m_RendererFeatures:\n  - {fileID: -77}\n" + feature);
        Graphics(Project.Add("Assets/Pipeline.asset", Asset(AssetScript, "Pipeline") + $"  m_RendererDataList:\n  - {Reference(renderer)}\n"));
        Open();
        Assert.That(((UniversalRenderPipelineAsset)GraphicsSettings.defaultRenderPipeline!).rendererDataList[0].name, Is.EqualTo("Renderer"));
        Assert.That(Reports, Has.Count.EqualTo(1).And.All.Contains("ScreenSpaceAmbientOcclusion has no stand-in"));
    }

    [Test]
    public void WhatOnlyToolsReadIsLeftOutSilently()
    {
        string version = "--- !u!114 &-9\nMonoBehaviour:\n  m_Script: {fileID: 11500000, guid: d0353a89b1f911e48b9e16bdc9f2e058, type: 3}\n  m_Name: \n  version: 7\n";
        Project.Add("Assets/Renderer.asset", Asset(RendererScript, "Renderer") + version);
        Assert.That(Open().Assets.LoadAll("Assets/Renderer.asset").Single(), Is.InstanceOf<UniversalRendererData>());
        Assert.That(Reports, Is.Empty);
    }

    [Test]
    public void TheDefaultAssetOfUniversalDrawsWhereTheProjectNamesNone()
    {
        Open();
        Assert.That(PipelineChoice.Apply(PipelineChoice.Universal), Does.StartWith("--pipeline universal: the project's settings name no asset"));
        Assert.That(((UniversalRenderPipelineAsset)GraphicsSettings.defaultRenderPipeline!).rendererDataList[0], Is.InstanceOf<UniversalRendererData>());
    }

    [TestCase(false)]
    [TestCase(true)]
    public void TheProjectsOwnAssetOfUniversalStays(bool ofLevel)
    {
        string asset = AddPipeline("Pipeline");
        if (ofLevel) Quality(0, Reference(asset));
        else Graphics(asset);
        Open();
        Assert.That(PipelineChoice.Apply(PipelineChoice.Universal), Is.Null);
        Assert.That(GraphicsSettings.defaultRenderPipeline!.name, Is.EqualTo("Pipeline"));
        Assert.That(PipelineChoice.Apply(null), Is.Null);
        Assert.That(GraphicsSettings.defaultRenderPipeline, Is.Not.Null);
    }

    [Test]
    public void BuiltInIsWithoutAnAsset()
    {
        Graphics(AddPipeline("Pipeline"));
        Quality(0, Reference(AddPipeline("Level")));
        Open();
        Assert.That(PipelineChoice.Apply(PipelineChoice.BuiltIn), Is.Null);
        Assert.That((GraphicsSettings.defaultRenderPipeline, QualitySettings.renderPipeline), Is.EqualTo(((RenderPipelineAsset?)null, (RenderPipelineAsset?)null)));
    }

    private static string Reference(string guid) => $"{{fileID: 11400000, guid: {guid}, type: 2}}";

    private static string Asset(string script, string name) =>
        Start + $"--- !u!114 &11400000\nMonoBehaviour:\n  m_Script: {{fileID: 11500000, guid: {script}, type: 3}}\n  m_Name: {name}\n";

    private static string Thing(long id, string name, string components) =>
        $"--- !u!1 &{id}\nGameObject:\n  m_Name: {name}\n--- !u!4 &{id + 10}\nTransform:\n  m_GameObject: {{fileID: {id}}}\n" + components;

    private static string Component(long id, long owner, string script) =>
        $"--- !u!114 &{id}\nMonoBehaviour:\n  m_GameObject: {{fileID: {owner}}}\n  m_Script: {{fileID: 11500000, guid: {script}, type: 3}}\n";

    private string AddPipeline(string name)
    {
        string renderer = Project.Add($"Assets/{name}Renderer.asset", Asset(RendererScript, name + "Renderer"));
        return Project.Add($"Assets/{name}.asset", Asset(AssetScript, name) + $"  m_RendererDataList:\n  - {Reference(renderer)}\n");
    }

    private void Graphics(string guid) =>
        Project.Add("ProjectSettings/GraphicsSettings.asset", Start + $"--- !u!30 &1\nGraphicsSettings:\n  m_CustomRenderPipeline: {Reference(guid)}\n");

    private void Quality(int current, params string[] levels) =>
        Project.Add("ProjectSettings/QualitySettings.asset", Start + $"--- !u!47 &1\nQualitySettings:\n  m_CurrentQuality: {current}\n  m_QualitySettings:\n"
            + string.Concat(levels.Select(l => $"  - name: A\n    customRenderPipeline: {l}\n")));

    private UnityProject Open() => UnityProject.Open(Project.Root, FindAssembly, new IncludeResolver(Project.Root), Reports.Add);
}
