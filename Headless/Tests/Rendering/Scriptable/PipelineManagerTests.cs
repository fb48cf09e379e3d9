using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Rendering;

public sealed class PipelineManagerTests : ScriptableFixture
{
    private readonly List<string> log = [];

    [SetUp]
    public void Listen()
    {
        log.Clear();
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        RenderPipelineManager.activeRenderPipelineAssetChanged += AssetChanged;
        RenderPipelineManager.activeRenderPipelineCreated += Created;
        RenderPipelineManager.activeRenderPipelineDisposed += Ended;
        RenderPipelineManager.activeRenderPipelineTypeChanged += TypeChanged;
        RenderPipelineManager.beginContextRendering += BeginContext;
        RenderPipelineManager.endContextRendering += EndContext;
        RenderPipelineManager.beginFrameRendering += BeginFrame;
        RenderPipelineManager.endFrameRendering += EndFrame;
        RenderPipelineManager.beginCameraRendering += BeginCamera;
        RenderPipelineManager.endCameraRendering += EndCamera;
    }

    [TearDown]
    public void Forget()
    {
        RenderPipelineManager.activeRenderPipelineAssetChanged -= AssetChanged;
        RenderPipelineManager.activeRenderPipelineCreated -= Created;
        RenderPipelineManager.activeRenderPipelineDisposed -= Ended;
        RenderPipelineManager.activeRenderPipelineTypeChanged -= TypeChanged;
        RenderPipelineManager.beginContextRendering -= BeginContext;
        RenderPipelineManager.endContextRendering -= EndContext;
        RenderPipelineManager.beginFrameRendering -= BeginFrame;
        RenderPipelineManager.endFrameRendering -= EndFrame;
        RenderPipelineManager.beginCameraRendering -= BeginCamera;
        RenderPipelineManager.endCameraRendering -= EndCamera;
    }

    [Test]
    public void EventsComeInUnitysOrder()
    {
        TestPipelineAsset asset = Asset("first", () => new TestPipeline((_, _) => log.Add("draw")));
        GraphicsSettings.defaultRenderPipeline = asset;
        Assert.That(log, Is.EqualTo(new[] { "asset -> first" }));
        Assert.That((RenderPipelineManager.currentPipeline, RenderPipelineManager.pipelineSwitchCompleted), Is.EqualTo(((RenderPipeline?)null, false)));
        Frame();
        Assert.That(RenderPipelineManager.pipelineSwitchCompleted, Is.True);
        Assert.That(log.Skip(1), Is.EqualTo(new[]
        {
            "created", "type", "begin frame", "begin context", "begin camera", "end camera", "draw", "end frame", "end context",
        }));
    }

    [Test]
    public void AnotherAssetEndsThePipeline()
    {
        GraphicsSettings.defaultRenderPipeline = Asset("first", () => new TestPipeline((_, _) => { }) { Disposed = () => log.Add("dispose") });
        Frame();
        RenderPipeline first = RenderPipelineManager.currentPipeline!;
        log.Clear();
        GraphicsSettings.defaultRenderPipeline = Asset("second", () => new OtherPipeline((_, _) => { }));
        Frame();
        Assert.That(log.Take(5), Is.EqualTo(new[] { "asset first -> second", "ended", "dispose", "created", "type" }));
        Assert.That(first.disposed, Is.True);
        Assert.That(RenderPipelineManager.currentPipeline, Is.TypeOf<OtherPipeline>());
        log.Clear();
        GraphicsSettings.defaultRenderPipeline = null;
        Frame();
        Assert.That(log, Is.EqualTo(new[] { "asset second -> ", "ended", "type" }));
        Assert.That(RenderPipelineManager.currentPipeline, Is.Null);
    }

    [Test]
    public void AChangedAssetMakesItsPipelineAnew()
    {
        TestPipelineAsset asset = Asset("first", () => new TestPipeline((_, _) => { }));
        GraphicsSettings.defaultRenderPipeline = asset;
        Frame();
        RenderPipeline first = RenderPipelineManager.currentPipeline!;
        asset.Change();
        Frame();
        Assert.That(first.disposed, Is.True);
        Assert.That(RenderPipelineManager.currentPipeline, Is.Not.Null.And.Not.SameAs(first));
        Assert.That(log.Count(l => l == "created"), Is.EqualTo(2));
        Assert.That(log.Count(l => l == "type"), Is.EqualTo(1));
    }

    [Test]
    public void TheQualityLevelsAssetTakesTheDefaultsPlace()
    {
        TestPipelineAsset normal = Asset("default", () => new TestPipeline((_, _) => { }));
        TestPipelineAsset quality = Asset("quality", () => new OtherPipeline((_, _) => { }));
        (GraphicsSettings.defaultRenderPipeline, QualitySettings.renderPipeline) = (normal, quality);
        Assert.That(GraphicsSettings.currentRenderPipeline, Is.SameAs(quality));
        Frame();
        Assert.That(RenderPipelineManager.currentPipeline, Is.TypeOf<OtherPipeline>());
        QualitySettings.renderPipeline = null;
        Assert.That(GraphicsSettings.currentRenderPipeline, Is.SameAs(normal));
    }

    [Test]
    public void APipelineThatCannotBeMadeIsReportedAndNothingIsDrawn()
    {
        GraphicsSettings.defaultRenderPipeline = Asset("broken", () => throw new InvalidOperationException("no such pipeline"));
        Frame();
        Assert.That(TakeErrors().Single(), Does.Contain("no such pipeline"));
    }

    private static TestPipelineAsset Asset(string name, Func<RenderPipeline> make)
    {
        var asset = ScriptableObject.CreateInstance<TestPipelineAsset>();
        (asset.name, asset.Make) = (name, make);
        return asset;
    }

    private void AssetChanged(RenderPipelineAsset? from, RenderPipelineAsset? to) =>
        log.Add($"asset {(from == null ? "" : from.name)} -> {(to == null ? "" : to.name)}".Replace("asset  ", "asset ", StringComparison.Ordinal));

    private void Created() => log.Add("created");

    private void Ended() => log.Add("ended");

    private void TypeChanged() => log.Add("type");

    private void BeginContext(ScriptableRenderContext context, List<Camera> cameras) => log.Add("begin context");

    private void EndContext(ScriptableRenderContext context, List<Camera> cameras) => log.Add("end context");

    private void BeginFrame(ScriptableRenderContext context, Camera[] cameras) => log.Add("begin frame");

    private void EndFrame(ScriptableRenderContext context, Camera[] cameras) => log.Add("end frame");

    private void BeginCamera(ScriptableRenderContext context, Camera camera) => log.Add("begin camera");

    private void EndCamera(ScriptableRenderContext context, Camera camera) => log.Add("end camera");
}
