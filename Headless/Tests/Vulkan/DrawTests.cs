using NUnit.Framework;
using System.Numerics;
using System.Runtime.InteropServices;
using Headless.Shaders;
using Headless.Vulkan;

namespace Headless.Tests.Vulkan;

public sealed class DrawTests : DrawFixture
{
    private const uint RedTexel = 0xff0000ff;
    private const uint GreenTexel = 0xff00ff00;
    private const uint BlueTexel = 0xffff0000;

    private static readonly RenderPipelineDescription Corner = Pipeline(DrawShaders.CornerTriangle, DrawShaders.Plain);

    [Test]
    public void ATriangleCoversItsHalfWithYUp()
    {
        BeginCleared();
        Recorder.Draw(Device.GetRenderPipeline(Corner), Bind(Red), 3);
        Recorder.EndRendering();

        uint[,] texels = Texels(Color);

        Assert.That(texels[1, 1], Is.EqualTo(RedTexel), "the upper left is covered");
        Assert.That(texels[Size - 2, Size - 2], Is.EqualTo(BlueTexel), "the lower right is not");
        Assert.That(texels.Cast<uint>().Count(texel => texel == RedTexel), Is.EqualTo(Size * Size / 2).Within(Size));
    }

    [TestCase(0.6f, 0.4f, RedTexel)]
    [TestCase(0.4f, 0.6f, GreenTexel)]
    public void TheNearerTriangleWinsInReversedDepth(float firstDepth, float secondDepth, uint expected)
    {
        BeginCleared();
        Recorder.Draw(Device.GetRenderPipeline(Corner), Bind(Red, firstDepth), 3);
        Recorder.Draw(Device.GetRenderPipeline(Corner), Bind(Green, secondDepth), 3);
        Recorder.EndRendering();

        Assert.That(Texels(Color)[1, 1], Is.EqualTo(expected));
        float[] depth = MemoryMarshal.Cast<byte, float>(Device.ReadTexture(Depth)).ToArray();
        Assert.That(depth.Max(), Is.EqualTo(0.6f));
        Assert.That(depth.Min(), Is.Zero);
    }

    [Test]
    public void ClockwiseIsTheFront()
    {
        RenderPipelineDescription front = Pipeline(DrawShaders.CornerTriangle, DrawShaders.Plain);
        RenderPipelineDescription culled = new() { Stages = front.Stages, ColorFormats = front.ColorFormats, DepthFormat = front.DepthFormat, Cull = GpuCull.Front };
        BeginCleared();
        Recorder.Draw(Device.GetRenderPipeline(culled), Bind(Red), 3);
        Recorder.EndRendering();

        Assert.That(Texels(Color)[1, 1], Is.EqualTo(BlueTexel));
    }

    [Test]
    public void TheGeometryStageMakesSquares()
    {
        if (!Device.Limits.GeometryShader)
        {
            Assert.Ignore($"{Device.Adapter.Name} has no geometry shader");
        }

        using GpuBuffer centers = StorageBuffer<Vector2>([new(-0.5f, 0.5f), new(0.5f, -0.5f)]);
        ResourceBindings bindings = Bind(Red);
        bindings.SetBuffer(0, 0, centers);
        bindings.SetUniform(1, 0, MemoryMarshal.AsBytes<float>([0.25f]));
        BeginCleared();
        Recorder.Draw(Device.GetRenderPipeline(Pipeline(DrawShaders.PointVertex, DrawShaders.Squares, DrawShaders.Plain)), bindings, 2);
        Recorder.EndRendering();

        uint[,] texels = Texels(Color);

        Assert.That(texels[4, 4], Is.EqualTo(RedTexel));
        Assert.That(texels[12, 12], Is.EqualTo(RedTexel));
        Assert.That(texels[4, 12], Is.EqualTo(BlueTexel));
        Assert.That(texels.Cast<uint>().Count(texel => texel == RedTexel), Is.EqualTo(2 * 4 * 4));
    }

    [Test]
    public void MeshesAreDrawnFromVertexAndIndexBuffers()
    {
        using GpuBuffer vertices = StorageBuffer<Vector2>([new(9, 9), new(-1, 1), new(1, 1), new(-1, -1)], BufferUse.Vertex, "vertices");
        using GpuBuffer indices = StorageBuffer<ushort>([9, 0, 1, 2], BufferUse.Index, "indices");
        RenderPipelineDescription mesh = new()
        {
            Stages = [DrawShaders.MeshVertex, DrawShaders.Plain],
            ColorFormats = [GpuFormat.R8G8B8A8Unorm],
            DepthFormat = GpuFormat.D32Float,
            DepthCompare = GpuCompare.Always,
            Streams = [new VertexStream(0, 8)],
            Attributes = [new VertexAttribute(0, GpuVertexFormat.Float2, 0, 0)],
        };
        BeginCleared();
        Recorder.SetVertexBuffer(0, vertices);
        Recorder.SetIndexBuffer(indices, 0, wide: false);
        Recorder.DrawIndexed(Device.GetRenderPipeline(mesh), Bind(Red), 3, firstIndex: 1, baseVertex: 1);
        Recorder.EndRendering();

        uint[,] texels = Texels(Color);

        Assert.That(texels[1, 1], Is.EqualTo(RedTexel));
        Assert.That(texels[Size - 2, Size - 2], Is.EqualTo(BlueTexel));
    }

    [Test]
    public void IndirectDrawTakesItsCountFromTheDevice()
    {
        using GpuBuffer arguments = StorageBuffer<uint>([0, 0, 0, 0, 3, 1, 0, 0], BufferUse.Indirect | BufferUse.Storage, "arguments");
        BeginCleared();
        Recorder.DrawIndirect(Device.GetRenderPipeline(Corner), Bind(Red), arguments, 0);
        Recorder.EndRendering();
        Assert.That(Texels(Color).Cast<uint>(), Is.All.EqualTo(BlueTexel));

        BeginCleared();
        Recorder.DrawIndirect(Device.GetRenderPipeline(Corner), Bind(Red), arguments, 16);
        Recorder.EndRendering();
        Assert.That(Texels(Color)[1, 1], Is.EqualTo(RedTexel));
    }

    [Test]
    public void CopiesAndDispatchesBetweenDrawsKeepTheTargets()
    {
        using GpuBuffer centers = StorageBuffer<Vector2>([new(-2, -2)]);
        using GpuBuffer filled = StorageBuffer(4);
        BeginCleared();
        Recorder.Draw(Device.GetRenderPipeline(Corner), Bind(Red), 3);
        Recorder.UpdateBuffer(centers, 0, MemoryMarshal.AsBytes<Vector2>([new(0.5f, -0.5f)]));
        Recorder.Dispatch(Device.GetComputePipeline(Kernels.Fill), Kernels.Bind(1, 9, filled), 1, 1, 1);
        ResourceBindings bindings = Bind(Green);
        bindings.SetBuffer(0, 0, centers);
        bindings.SetUniform(1, 0, MemoryMarshal.AsBytes<float>([0.25f]));
        Recorder.Draw(Device.GetRenderPipeline(Pipeline(DrawShaders.PointVertex, DrawShaders.Squares, DrawShaders.Plain)), bindings, 1);
        Recorder.EndRendering();

        uint[,] texels = Texels(Color);

        Assert.That(texels[1, 1], Is.EqualTo(RedTexel));
        Assert.That(texels[12, 12], Is.EqualTo(GreenTexel));
        Assert.That(texels[Size - 1, Size - 1], Is.EqualTo(BlueTexel));
        Assert.That(Read<uint>(filled)[0], Is.EqualTo(9u));
    }

    [Test]
    public void TargetsWithoutADrawAreCleared()
    {
        BeginCleared();
        Recorder.EndRendering();
        Assert.That(Texels(Color).Cast<uint>(), Is.All.EqualTo(BlueTexel));
    }

    [Test]
    public void ScissorAndViewportLimitTheDraw()
    {
        BeginCleared();
        Recorder.SetViewport(new GpuViewport(8, 0, 8, 8));
        Recorder.SetScissor(8, 0, 2, 2);
        Recorder.Draw(Device.GetRenderPipeline(Corner), Bind(Red), 3);
        Recorder.EndRendering();

        uint[,] texels = Texels(Color);

        Assert.That(texels[8, 0], Is.EqualTo(RedTexel));
        Assert.That(texels.Cast<uint>().Count(texel => texel == RedTexel), Is.EqualTo(4));
    }

    [Test]
    public void ResolveAveragesFourSamples()
    {
        using GpuTexture color = Target(GpuFormat.R8G8B8A8Unorm, "color x4", 4, 0);
        using GpuTexture depth = Target(GpuFormat.D32Float, "depth x4", 4, 0);
        RenderPipelineDescription four = new() { Stages = Corner.Stages, ColorFormats = Corner.ColorFormats, DepthFormat = GpuFormat.D32Float, DepthCompare = GpuCompare.GreaterEqual, Samples = 4 };
        Recorder.BeginRendering(new RenderTargets
        {
            Colors = [new ColorTarget(color) { Load = TargetLoad.Clear, Resolve = Color }],
            Depth = new DepthTarget(depth) { Load = TargetLoad.Clear },
        });
        Recorder.Draw(Device.GetRenderPipeline(four), Bind(Red), 3);
        Recorder.EndRendering();

        uint[,] texels = Texels(Color);

        Assert.That(texels[1, 1], Is.EqualTo(RedTexel));
        Assert.That(Enumerable.Range(0, Size).Select(x => texels[x, Size - 1 - x] & 0xff), Has.Some.InRange(1u, 254u), "edge texels are mixed");
    }

    [Test]
    public void AlphaBlendMixesSourceAndTarget()
    {
        RenderPipelineDescription blended = new()
        {
            Stages = Corner.Stages,
            ColorFormats = Corner.ColorFormats,
            DepthFormat = GpuFormat.D32Float,
            DepthCompare = GpuCompare.Always,
            DepthWrite = false,
            Blend = [new BlendState { SourceColor = GpuBlend.SrcAlpha, TargetColor = GpuBlend.OneMinusSrcAlpha }],
        };
        BeginCleared();
        Recorder.Draw(Device.GetRenderPipeline(blended), Bind(new Vector4(1, 0, 0, 0.5f)), 3);
        Recorder.EndRendering();

        uint texel = Texels(Color)[1, 1];

        Assert.That(texel & 0xff, Is.EqualTo(128).Within(1), "red");
        Assert.That((texel >> 16) & 0xff, Is.EqualTo(128).Within(1), "blue");
    }

    [Test]
    public void MoreDrawsThanACommandBufferHoldsAllArrive()
    {
        using GpuTexture sum = Target(GpuFormat.R32Float, "sum");
        RenderPipelineDescription additive = new()
        {
            Stages = Corner.Stages,
            ColorFormats = [GpuFormat.R32Float],
            DepthCompare = GpuCompare.Always,
            DepthWrite = false,
            Blend = [new BlendState { TargetColor = GpuBlend.One }],
        };
        ResourceBindings bindings = Bind(new Vector4(1, 0, 0, 1));
        GpuRenderPipeline pipeline = Device.GetRenderPipeline(additive);
        Recorder.BeginRendering(new RenderTargets { Colors = [new ColorTarget(sum) { Load = TargetLoad.Clear }] });
        for (int i = 0; i < 5000; i++)
        {
            Recorder.Draw(pipeline, bindings, 3);
        }

        Recorder.EndRendering();
        Assert.That(MemoryMarshal.Cast<byte, float>(Device.ReadTexture(sum))[Size + 1], Is.EqualTo(5000f));
    }

    [Test]
    public void AFragmentMayWriteABufferThatTheNextDrawReads()
    {
        ShaderBinary count = TestShader.Stage(ShaderStage.Fragment, "Count", """
            [[vk::binding(0, 2)]] RWStructuredBuffer<uint> _Counter;
            float4 Count() : SV_Target
            {
                uint old;
                InterlockedAdd(_Counter[0], 1, old);
                return 0;
            }
            """, TestShader.Write(0, "_Counter"));
        using GpuBuffer counter = StorageBuffer(4, "counter");
        ResourceBindings bindings = new();
        bindings.SetBuffer(2, 0, counter);
        GpuRenderPipeline pipeline = Device.GetRenderPipeline(Pipeline(DrawShaders.FullScreen, count));
        BeginCleared();
        for (int i = 0; i < 3; i++)
        {
            Recorder.Draw(pipeline, bindings, 3);
        }

        Recorder.EndRendering();
        Assert.That(Read<uint>(counter)[0], Is.EqualTo(3u * Size * Size));
    }

    [Test]
    public void ADrawForOtherTargetsIsNamed()
    {
        RenderPipelineDescription other = new() { Stages = Corner.Stages, ColorFormats = [GpuFormat.R16G16B16A16Float], Name = "Other" };
        BeginCleared();
        Assert.That(
            () => Recorder.Draw(Device.GetRenderPipeline(other), Bind(Red), 3),
            Throws.TypeOf<GpuException>().With.Message.Contains("'Other'").And.Message.Contains("R16G16B16A16Float"));
        Recorder.EndRendering();
    }

    [Test]
    public void ReadingTheTargetIsNamed()
    {
        ResourceBindings bindings = new();
        bindings.SetTexture(2, 0, Color);
        bindings.SetSampler(2, 1, Device.CreateSampler(new GpuSamplerDescription()));
        BeginCleared();
        Assert.That(
            () => Recorder.Draw(Device.GetRenderPipeline(Pipeline(DrawShaders.FullScreen, DrawShaders.Textured)), bindings, 3),
            Throws.TypeOf<GpuException>().With.Message.Contains("'color'"));
        Recorder.EndRendering();
    }

    [Test]
    public void AMissingVertexAttributeIsNamed() =>
        Assert.That(
            () => Device.GetRenderPipeline(Pipeline(DrawShaders.MeshVertex, DrawShaders.Plain)),
            Throws.TypeOf<GpuException>().With.Message.Contains("POSITION"));
}
