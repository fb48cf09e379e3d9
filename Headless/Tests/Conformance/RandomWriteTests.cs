using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using Headless.Tests.Rendering;

namespace Headless.Tests.Conformance;

/// <summary>Pixel shaders that write buffers and textures.</summary>
public sealed class RandomWriteTests : RenderFixture
{
    private const string Writer = """
        Shader "Test/Writer"
        {
            SubShader
            {
                Pass
                {
                    Cull Off ZTest Always ZWrite Off
                    HLSLPROGRAM
                    #pragma target 5.0
                    #pragma vertex Vertex
                    #pragma fragment Fragment
                    RWStructuredBuffer<uint> _Pixels : register(u1);
                    RWTexture2D<float4> _Copy : register(u2);
                    float4 Vertex(uint id : SV_VertexID) : SV_Position
                    {
                        return float4(id == 1 ? 3 : -1, id == 2 ? 3 : -1, 0.5, 1);
                    }
                    float4 Fragment(float4 place : SV_Position) : SV_Target
                    {
                        uint before;
                        InterlockedAdd(_Pixels[0], 1, before);
                        uint number = _Pixels.IncrementCounter();
                        _Copy[uint2(place.xy)] = float4(place.xy, 0, 1);
                        return number >= 0;
                    }
                    ENDHLSL
                }
            }
        }
        """;

    [TestCase(false)]
    [TestCase(true)]
    public void APixelShaderWritesWhatIsSetAtItsRegisters(bool byCommandBuffer)
    {
        using var pixels = new GraphicsBuffer(GraphicsBuffer.Target.Counter, 1, 4);
        using var count = new GraphicsBuffer(GraphicsBuffer.Target.Raw, 1, 4);
        pixels.SetData(new uint[1]);
        pixels.SetCounterValue(100);
        var target = new RenderTexture(8, 4, 0, RenderTextureFormat.ARGBFloat);
        var copy = new RenderTexture(new RenderTextureDescriptor(8, 4, RenderTextureFormat.ARGBFloat, 0) { enableRandomWrite = true });
        copy.Create();
        Material material = MaterialOf(Writer);
        using var commands = new CommandBuffer();
        if (byCommandBuffer)
        {
            commands.SetRandomWriteTarget(1, pixels);
            commands.SetRandomWriteTarget(2, new RenderTargetIdentifier(copy));
        }
        else
        {
            Graphics.SetRandomWriteTarget(1, pixels);
            Graphics.SetRandomWriteTarget(2, copy);
        }

        commands.SetRenderTarget(target);
        commands.DrawProcedural(Matrix4x4.identity, material, 0, MeshTopology.Triangles, 3);
        commands.ClearRandomWriteTargets();
        Graphics.ExecuteCommandBuffer(commands);
        Graphics.ClearRandomWriteTargets();
        GraphicsBuffer.CopyCount(pixels, count, 0);
        var words = new uint[1];
        pixels.GetData(words);
        Assert.That(words[0], Is.EqualTo(32u), "every pixel once");
        count.GetData(words);
        Assert.That(words[0], Is.EqualTo(32u), "the counter was set to 0 by SetRandomWriteTarget");
        AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(copy);
        request.WaitForCompletion();
        Assert.That(request.GetData<Vector4>()[7].x, Is.EqualTo(7.5f));
    }

    [Test]
    public void ACounterIsPreservedWhereAskedFor()
    {
        using var pixels = new GraphicsBuffer(GraphicsBuffer.Target.Counter, 1, 4);
        using var count = new GraphicsBuffer(GraphicsBuffer.Target.Raw, 1, 4);
        pixels.SetCounterValue(100);
        Graphics.SetRandomWriteTarget(1, pixels, true);
        GraphicsBuffer.CopyCount(pixels, count, 0);
        var words = new uint[1];
        count.GetData(words);
        Assert.That(words[0], Is.EqualTo(100u));
        Graphics.SetRandomWriteTarget(1, pixels);
        GraphicsBuffer.CopyCount(pixels, count, 0);
        count.GetData(words);
        Assert.That(words[0], Is.Zero);
        Graphics.ClearRandomWriteTargets();
    }

    [Test]
    public void AMissingWriteTargetIsNamed()
    {
        var target = new RenderTexture(8, 4, 0, RenderTextureFormat.ARGBFloat);
        using var commands = new CommandBuffer();
        commands.SetRenderTarget(target);
        commands.DrawProcedural(Matrix4x4.identity, MaterialOf(Writer), 0, MeshTopology.Triangles, 3);
        Graphics.ExecuteCommandBuffer(commands);
        Assert.That(TakeErrors().Single(), Does.Contain("_Pixels"));
        Assert.That(() => Graphics.SetRandomWriteTarget(8, target), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }
}
