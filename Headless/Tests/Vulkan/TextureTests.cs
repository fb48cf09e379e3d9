using NUnit.Framework;
using System.Numerics;
using System.Runtime.InteropServices;
using Headless.Shaders;
using Headless.Vulkan;

namespace Headless.Tests.Vulkan;

public sealed class TextureTests : DrawFixture
{
    [Test]
    public void NewTexturesAreZero([Values] GpuFormat format)
    {
        if (format == GpuFormat.None)
        {
            return;
        }

        using GpuTexture texture = Device.CreateTexture(new GpuTextureDescription { Width = 7, Height = 5, Format = format }, "new");
        Assert.That(Device.ReadTexture(texture), Is.All.Zero);
    }

    [TestCase(GpuTextureDimension.Texture2D, 13, 7, 1, 1)]
    [TestCase(GpuTextureDimension.Texture3D, 5, 4, 3, 1)]
    [TestCase(GpuTextureDimension.Cube, 8, 8, 1, 6)]
    [TestCase(GpuTextureDimension.Texture2DArray, 3, 9, 1, 4)]
    public void TexelsComeBackAsWritten(GpuTextureDimension dimension, int width, int height, int depth, int layers)
    {
        GpuTextureDescription description = new()
        {
            Width = width, Height = height, Depth = depth, Layers = layers, Dimension = dimension, Format = GpuFormat.R32Uint,
        };
        using GpuTexture texture = Device.CreateTexture(description, "texture");
        byte[] data = new byte[texture.MipBytes(0)];
        new Random(1).NextBytes(data);
        Recorder.UpdateTexture(texture, 0, layers - 1, data);
        Assert.That(Device.ReadTexture(texture, 0, layers - 1), Is.EqualTo(data));
    }

    [Test]
    public void SamplingReadsWhatWasUploadedWithTheFirstRowOnTop()
    {
        using GpuTexture image = Image(2, 2, 1, [0xff0000ff, 0xff00ff00, 0xffff0000, 0xffffffff]);
        uint[,] texels = DrawTextured(image, GpuFilter.Point);
        Assert.That(
            new[] { texels[1, 1], texels[14, 1], texels[1, 14], texels[14, 14] },
            Is.EqualTo(new[] { 0xff0000ff, 0xff00ff00, 0xffff0000, 0xffffffff }));
    }

    [Test]
    public void GeneratedMipsAreMeans()
    {
        using GpuTexture image = Image(4, 4, 3, Enumerable.Range(0, 16).Select(i => i % 4 < 2 ? 0xff000000u : 0xff0000c8u).ToArray());
        Recorder.GenerateMips(image);
        uint smallest = MemoryMarshal.Cast<byte, uint>(Device.ReadTexture(image, 2))[0];
        Assert.That(smallest & 0xff, Is.EqualTo(100).Within(1));
    }

    [Test]
    public void ComparisonSamplersCompare([Values(0.25f, 0.75f)] float stored)
    {
        using GpuTexture map = Target(GpuFormat.D32Float, "map");
        Recorder.BeginRendering(new RenderTargets { Depth = new DepthTarget(map) { Load = TargetLoad.Clear, Clear = stored } });
        Recorder.EndRendering();
        ResourceBindings bindings = new();
        bindings.SetTexture(2, 0, map);
        bindings.SetSampler(2, 1, Device.CreateSampler(new GpuSamplerDescription { Compare = GpuCompare.LessEqual, WrapU = GpuWrap.Clamp, WrapV = GpuWrap.Clamp }));
        BeginCleared();
        Recorder.Draw(Device.GetRenderPipeline(Pipeline(DrawShaders.FullScreen, DrawShaders.Shadow)), bindings, 3);
        Recorder.EndRendering();
        Assert.That(Texels(Color)[8, 8] & 0xff, Is.EqualTo(0.5f <= stored ? 255u : 0u));
    }

    [TestCase(GpuFormat.R32G32B32A32Float)]
    [TestCase(GpuFormat.R16G16B16A16Float)]
    [TestCase(GpuFormat.R8G8B8A8Unorm)]
    public void KernelsWriteTexturesOfAnyFormat(GpuFormat format)
    {
        ShaderBinary kernel = TestShader.Kernel("Paint", 8, """
            [[vk::binding(0, 0)]] RWTexture2D<float4> _Target;
            [numthreads(8, 1, 1)] void Paint(uint3 id : SV_DispatchThreadID) { _Target[id.xy] = float4(1, 0, 1, 1); }
            """, TestShader.Image(0, "_Target", ImageFormat.Rgba32f));
        using GpuTexture texture = Device.CreateTexture(
            new GpuTextureDescription { Width = Size, Height = Size, Format = format, Usage = TextureUse.Sampled | TextureUse.Storage }, "painted");
        ResourceBindings bindings = new();
        bindings.SetTexture(0, 0, texture);
        Recorder.Dispatch(Device.GetComputePipeline(kernel), bindings, Size / 8, Size, 1);

        Assert.That(DrawTextured(texture, GpuFilter.Bilinear).Cast<uint>(), Is.All.EqualTo(0xffff00ffu));
    }

    [Test]
    public void CopiesKeepTexels()
    {
        using GpuTexture source = Image(2, 2, 1, [1, 2, 3, 4]);
        using GpuTexture target = Image(2, 2, 1, [0, 0, 0, 0]);
        Recorder.CopyTexture(source, 0, 0, target, 0, 0);
        Assert.That(MemoryMarshal.Cast<byte, uint>(Device.ReadTexture(target)).ToArray(), Is.EqualTo(new uint[] { 1, 2, 3, 4 }));
    }

    [Test]
    public void ATextureOfTheWrongShapeIsNamed()
    {
        using GpuTexture volume = Device.CreateTexture(
            new GpuTextureDescription { Width = 2, Height = 2, Depth = 2, Dimension = GpuTextureDimension.Texture3D, Format = GpuFormat.R8G8B8A8Unorm }, "volume");
        Assert.That(
            () => DrawTextured(volume, GpuFilter.Point),
            Throws.TypeOf<GpuException>().With.Message.Contains("'volume'").And.Message.Contains("'_Image'"));
        Recorder.EndRendering();
    }

    [Test]
    public void ATooLargeTextureIsNamed() =>
        Assert.That(
            () => Device.CreateTexture(new GpuTextureDescription { Width = Device.Limits.MaxTexture2D + 1, Height = 1, Format = GpuFormat.R8Unorm }, "huge"),
            Throws.TypeOf<GpuException>().With.Message.Contains("'huge'"));

    private GpuTexture Image(int width, int height, int mips, uint[] texels)
    {
        GpuTexture texture = Device.CreateTexture(
            new GpuTextureDescription { Width = width, Height = height, MipLevels = mips, Format = GpuFormat.R8G8B8A8Unorm }, "image");
        Recorder.UpdateTexture(texture, 0, 0, MemoryMarshal.AsBytes<uint>(texels));
        return texture;
    }

    private uint[,] DrawTextured(GpuTexture image, GpuFilter filter)
    {
        ResourceBindings bindings = new();
        bindings.SetTexture(2, 0, image);
        bindings.SetSampler(2, 1, Device.CreateSampler(new GpuSamplerDescription { Filter = filter, WrapU = GpuWrap.Clamp, WrapV = GpuWrap.Clamp }));
        BeginCleared();
        Recorder.Draw(Device.GetRenderPipeline(Pipeline(DrawShaders.FullScreen, DrawShaders.Textured)), bindings, 3);
        Recorder.EndRendering();
        return Texels(Color);
    }
}
