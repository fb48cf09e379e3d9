using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.Universal;

namespace Headless.Tests.Universal;

/// <summary>What a pass of a user's may rely on: order, culling, what it must declare, and that nothing of one camera reaches another.</summary>
public sealed class RenderGraphTests : UniversalFixture
{
    private UniversalRenderPipeline Pipeline => (UniversalRenderPipeline)RenderPipelineManager.currentPipeline!;

    [Test]
    public void PassesRunInTheOrderOfTheirEvents()
    {
        Camera(Vector3.zero, Vector3.forward);
        var order = new List<string>();
        ScriptableRenderPass[] passes =
        [
            new Recording(RenderPassEvent.AfterRenderingTransparents, (graph, _) => Note(graph, "transparents", order)),
            new Recording(RenderPassEvent.BeforeRenderingShadows, (graph, _) => Note(graph, "shadows", order)),
            new Recording(RenderPassEvent.AfterRenderingTransparents, (graph, _) => Note(graph, "transparents, second", order)),
            new Recording(RenderPassEvent.AfterRenderingSkybox, (graph, _) => Note(graph, "sky", order)),
        ];
        using (Enqueue(passes))
        {
            Frame();
        }

        Assert.That(order, Is.EqualTo(new[] { "shadows", "sky", "transparents", "transparents, second" }));
        List<string> all = [.. Pipeline.LastPasses];
        Assert.That(all.IndexOf("Draw Opaque Objects"), Is.LessThan(all.IndexOf("sky")));
        Assert.That(all.IndexOf("sky"), Is.LessThan(all.IndexOf("Draw Transparent Objects")));
    }

    [Test]
    public void TheQueueIsEmptyAfterEachCamera()
    {
        Camera(Vector3.zero, Vector3.forward);
        Camera(Vector3.zero, Vector3.back).depth = 1f;
        int recorded = 0;
        var pass = new Recording(RenderPassEvent.BeforeRenderingOpaques, (_, _) => recorded++);
        bool once = false;
        void Add(ScriptableRenderContext context, Camera camera)
        {
            if (!once)
            {
                camera.GetUniversalAdditionalCameraData().scriptableRenderer!.EnqueuePass(pass);
            }

            once = true;
        }

        RenderPipelineManager.beginCameraRendering += Add;
        Frame(2);
        RenderPipelineManager.beginCameraRendering -= Add;
        Assert.That(recorded, Is.EqualTo(1));
    }

    [Test]
    public void WhatNobodyReadsIsNotRun()
    {
        Camera(Vector3.zero, Vector3.forward);
        var order = new List<string>();
        var pass = new Recording(RenderPassEvent.BeforeRenderingOpaques, (graph, _) =>
        {
            TextureHandle unread = Texture(graph, "unread");
            TextureHandle read = Texture(graph, "read");
            Write(graph, "unread", unread, order);
            Write(graph, "read", read, order);
            using IUnsafeRenderGraphBuilder builder = graph.AddUnsafePass("reader", out Data data);
            data.Order = order;
            builder.UseTexture(read);
            builder.AllowPassCulling(false);
            builder.SetRenderFunc((Data d, UnsafeGraphContext _) => d.Order.Add("reader"));
        });
        using (Enqueue(pass))
        {
            Frame();
        }

        Assert.That(order, Is.EqualTo(new[] { "read", "reader" }));
    }

    [Test]
    public void ChangingWhatOthersSeeMustBeAskedFor()
    {
        Camera(Vector3.zero, Vector3.forward);
        var pass = new Recording(RenderPassEvent.BeforeRenderingOpaques, (graph, _) =>
        {
            using IUnsafeRenderGraphBuilder builder = graph.AddUnsafePass("sets", out Data _);
            builder.AllowPassCulling(false);
            builder.SetRenderFunc((Data _, UnsafeGraphContext context) => context.cmd.SetGlobalFloat("_Any", 1f));
        });
        using (Enqueue(pass))
        {
            Frame();
        }

        Assert.That(TakeErrors().Single(), Does.Contain("Modifying global state from this command buffer is not allowed"));
    }

    [Test]
    public void ATextureMustBeDeclared()
    {
        Camera(Vector3.zero, Vector3.forward);
        var pass = new Recording(RenderPassEvent.BeforeRenderingOpaques, (graph, _) =>
        {
            TextureHandle other = Texture(graph, "other");
            using IUnsafeRenderGraphBuilder builder = graph.AddUnsafePass("binds", out Data _);
            builder.AllowPassCulling(false);
            builder.AllowGlobalStateModification(true);
            builder.SetRenderFunc((Data _, UnsafeGraphContext context) => context.cmd.SetGlobalTexture("_Any", other));
        });
        using (Enqueue(pass))
        {
            Frame();
        }

        Assert.That(TakeErrors().Single(), Does.Contain("never registered with the pass builder"));
    }

    // In compatibility mode passes run by Execute, and draw into the camera's colour.
    [TestCase(false)]
    [TestCase(true)]
    public void APassRunsByTheWayOfItsLine(bool compatibility)
    {
        UniversalRenderPipeline.CompatibilityMode = compatibility;
        Camera(Vector3.zero, Vector3.forward);
        var pass = new Both();
        using (Enqueue(pass))
        {
            Frame(2);
        }

        Assert.That((pass.Recorded, pass.Executed), Is.EqualTo(compatibility ? (0, 2) : (2, 0)));
        Assert.That(IsGreen(Headless.Tests.Rendering.Picture.OfScreen().At(64, 48)));
    }

    [Test]
    public void AFeatureOfTheRendererAddsItsPasses()
    {
        var feature = ScriptableObject.CreateInstance<Feature>();
        Renderer.rendererFeatures.Add(feature);
        Renderer.SetDirty();
        Camera(Vector3.zero, Vector3.forward);
        Frame(2);
        Assert.That((feature.Made, feature.Asked, feature.Pass!.Recorded), Is.EqualTo((1, 2, 2)));
        feature.SetActive(false);
        Frame();
        Assert.That(feature.Asked, Is.EqualTo(2));
    }

    private static TextureHandle Texture(RenderGraph graph, string name) =>
        graph.CreateTexture(new TextureDesc(16, 16) { format = GraphicsFormat.R8G8B8A8_UNorm, name = name });

    private static void Write(RenderGraph graph, string name, TextureHandle target, List<string> order)
    {
        using IRasterRenderGraphBuilder builder = graph.AddRasterRenderPass(name, out Data data);
        data.Order = order;
        builder.SetRenderAttachment(target, 0);
        builder.SetRenderFunc((Data d, RasterGraphContext _) => d.Order.Add(name));
    }

    private static void Note(RenderGraph graph, string name, List<string> order)
    {
        using IUnsafeRenderGraphBuilder builder = graph.AddUnsafePass(name, out Data data);
        data.Order = order;
        builder.AllowPassCulling(false);
        builder.SetRenderFunc((Data d, UnsafeGraphContext _) => d.Order.Add(name));
    }

    private sealed class Data
    {
        public List<string> Order { get; set; } = [];
    }

    private sealed class Recording : ScriptableRenderPass
    {
        private readonly Action<RenderGraph, ContextContainer> record;

        public Recording(RenderPassEvent at, Action<RenderGraph, ContextContainer> record) => (renderPassEvent, this.record) = (at, record);

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData) => record(renderGraph, frameData);
    }

    private sealed class Both : ScriptableRenderPass
    {
        public Both() => renderPassEvent = RenderPassEvent.AfterRenderingTransparents;

        public int Recorded { get; private set; }
        public int Executed { get; private set; }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            Executed++;
            var cmd = new CommandBuffer { name = "Both" };
            cmd.ClearRenderTarget(false, true, Color.green);
            context.ExecuteCommandBuffer(cmd);
            cmd.Release();
        }

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            Recorded++;
            using IRasterRenderGraphBuilder builder = renderGraph.AddRasterRenderPass("Both", out Data _);
            builder.SetRenderAttachment(frameData.Get<UniversalResourceData>().activeColorTexture, 0);
            builder.SetRenderFunc((Data _, RasterGraphContext context) => context.cmd.ClearRenderTarget(false, true, Color.green));
        }
    }

    private sealed class Feature : ScriptableRendererFeature
    {
        public int Made { get; private set; }
        public int Asked { get; private set; }
        public Both? Pass { get; private set; }

        public override void Create()
        {
            Made++;
            Pass = new Both();
        }

        public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
        {
            Asked++;
            renderer.EnqueuePass(Pass!);
        }
    }
}
