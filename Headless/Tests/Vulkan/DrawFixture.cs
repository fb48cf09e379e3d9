using NUnit.Framework;
using System.Numerics;
using System.Runtime.InteropServices;
using Headless.Shaders;
using Headless.Vulkan;

namespace Headless.Tests.Vulkan;

/// <summary>A small color and depth target and what drawing to it needs.</summary>
public abstract class DrawFixture : DeviceFixture
{
    protected const int Size = 16;

    protected static readonly Vector4 Red = new(1, 0, 0, 1);
    protected static readonly Vector4 Green = new(0, 1, 0, 1);
    protected static readonly Vector4 Blue = new(0, 0, 1, 1);

    protected GpuTexture Color { get; private set; } = null!;

    protected GpuTexture Depth { get; private set; } = null!;

    [SetUp]
    public void CreateTargets()
    {
        Color = Target(GpuFormat.R8G8B8A8Unorm, "color");
        Depth = Target(GpuFormat.D32Float, "depth");
    }

    [TearDown]
    public void FreeTargets()
    {
        Color.Dispose();
        Depth.Dispose();
    }

    protected static RenderPipelineDescription Pipeline(params ShaderBinary[] stages) => new()
    {
        Stages = stages,
        ColorFormats = [GpuFormat.R8G8B8A8Unorm],
        DepthFormat = GpuFormat.D32Float,
        DepthCompare = GpuCompare.GreaterEqual,
        Topology = stages.Any(stage => stage.Stage == ShaderStage.Geometry) ? GpuTopology.Points : GpuTopology.Triangles,
    };

    protected static ResourceBindings Bind(Vector4 color, float depth = 0.5f)
    {
        ResourceBindings bindings = new();
        bindings.SetUniform(0, 0, MemoryMarshal.AsBytes<float>([depth]));
        bindings.SetUniform(2, 0, MemoryMarshal.AsBytes<Vector4>([color]));
        return bindings;
    }

    protected GpuTexture Target(GpuFormat format, string name, int samples = 1, TextureUse more = TextureUse.Sampled) =>
        Device.CreateTexture(
            new GpuTextureDescription { Width = Size, Height = Size, Format = format, Samples = samples, Usage = TextureUse.RenderTarget | more }, name);

    protected void BeginCleared() => Recorder.BeginRendering(new RenderTargets
    {
        Colors = [new ColorTarget(Color) { Load = TargetLoad.Clear, Clear = Blue }],
        Depth = new DepthTarget(Depth) { Load = TargetLoad.Clear, Clear = 0 },
    });

    /// <summary>The texel of a column and row, row 0 at the top; red in the low byte.</summary>
    protected uint[,] Texels(GpuTexture texture)
    {
        ReadOnlySpan<uint> data = MemoryMarshal.Cast<byte, uint>(Device.ReadTexture(texture));
        uint[,] texels = new uint[texture.Description.Width, texture.Description.Height];
        for (int i = 0; i < data.Length; i++)
        {
            texels[i % texture.Description.Width, i / texture.Description.Width] = data[i];
        }

        return texels;
    }
}
