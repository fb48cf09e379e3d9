using Headless.Shaders;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

public sealed class ResourceTests : SandboxTests
{
    [Test]
    public void KindsAndBindings()
    {
        ShaderBinary binary = Sandbox.Kernel("""
            cbuffer A : register(b1) { float _X; };
            StructuredBuffer<uint> _B : register(t1);
            RWStructuredBuffer<uint> _C : register(u1);
            ByteAddressBuffer _D; RWByteAddressBuffer _E : register(u3), _E2;
            Texture2D<float4> _F : register(t2); Texture3D<uint> _G; Texture2DArray _G2; TextureCube _G3;
            RWTexture2D<float> _H; RWTexture3D<uint2> _H2;
            SamplerState sampler_F : register(s1);
            StructuredBuffer<float> _NotUsed;
            float NotCalled() { return _NotUsed[0]; }
            [numthreads(8, 4, 2)] void CS(uint3 id : SV_DispatchThreadID)
            {
                float4 t = _F.SampleLevel(sampler_F, 0, 0) + _G[id] + _G2[id] + _G3.SampleLevel(sampler_F, 1, 0);
                _C[id.x] = _B[id.x] + _D.Load(4) + (uint)t.x;
                _E.Store(0, 1);
                _E2.Store(0, 1);
                _H[id.xy] = _X;
                _H2[id] = 3;
            }
            """);
        Assert.That(binary.Resources.Select(r => (r.Name, r.Kind, r.Dimension)), Is.EquivalentTo(
            new[]
            {
                ("A", ResourceKind.ConstantBuffer, ""),
                ("_B", ResourceKind.StructuredBuffer, ""),
                ("_C", ResourceKind.RWStructuredBuffer, ""),
                ("_D", ResourceKind.ByteAddressBuffer, ""),
                ("_E", ResourceKind.RWByteAddressBuffer, ""),
                ("_E2", ResourceKind.RWByteAddressBuffer, ""),
                ("_F", ResourceKind.Texture, "2D"),
                ("_G", ResourceKind.Texture, "3D"),
                ("_G2", ResourceKind.Texture, "2DArray"),
                ("_G3", ResourceKind.Texture, "Cube"),
                ("_H", ResourceKind.RWTexture, "2D"),
                ("_H2", ResourceKind.RWTexture, "3D"),
                ("sampler_F", ResourceKind.Sampler, ""),
            }));
        Assert.That(binary.Resources.Select(r => r.Binding), Is.Unique);
        Assert.That(Resource(binary, "_H").Format, Is.EqualTo(ImageFormat.R32f));
        Assert.That(Resource(binary, "_H2").Format, Is.EqualTo(ImageFormat.Rg32ui));
        Assert.That(Resource(binary, "_G").SampledType, Is.EqualTo("uint"));
        Assert.That((binary.GroupX, binary.GroupY, binary.GroupZ), Is.EqualTo((8, 4, 2)));
    }

    [Test]
    public void StorageFormatsFollowTheBoundTextures()
    {
        ShaderBinary binary = Sandbox.Kernel("""
            RWTexture2D<float4> _A, _B, _C;
            [numthreads(1, 1, 1)] void CS(uint3 id : SV_DispatchThreadID) { _A[id.xy] = _B[id.xy] + _A[id.yx]; _C[id.xy] = 1; }
            """);
        int a = Resource(binary, "_A").Binding;
        int c = Resource(binary, "_C").Binding;
        ShaderBinary changed = ImageFormats.With(
            binary, new Dictionary<int, ImageFormat> { [a] = ImageFormat.Rgba16f, [c] = ImageFormat.Rg8 });
        ShaderSandbox.Validate(changed);
        Assert.That(changed.Hash, Is.Not.EqualTo(binary.Hash));
        Assert.That(Resource(changed, "_A").Format, Is.EqualTo(ImageFormat.Rgba16f));
        Assert.That(Resource(changed, "_B").Format, Is.EqualTo(ImageFormat.Rgba32f));
        Assert.That(ImageFormats.With(changed, new Dictionary<int, ImageFormat> { [a] = ImageFormat.Rgba16f }), Is.SameAs(changed));
        ShaderBinary back = ImageFormats.With(
            changed, new Dictionary<int, ImageFormat> { [a] = ImageFormat.Rgba32f, [c] = ImageFormat.Rgba32f });
        ShaderSandbox.Validate(back);
        Assert.Throws<ArgumentException>(
            () => ImageFormats.With(binary, new Dictionary<int, ImageFormat> { [a] = ImageFormat.Rgba32ui }));
    }

    [Test]
    public void AtomicsWithSignedConstantsAreValid()
    {
        Assert.DoesNotThrow(() => Sandbox.Kernel("""
            RWByteAddressBuffer _Raw; RWStructuredBuffer<uint> _Counters; groupshared uint total;
            [numthreads(8, 1, 1)] void CS(uint i : SV_GroupIndex)
            {
                uint old;
                InterlockedAdd(_Counters[0], 1);
                InterlockedMax(_Counters[1], i);
                InterlockedAdd(total, 1, old);
                InterlockedCompareExchange(_Counters[2], 0, 1, old);
                _Raw.InterlockedAdd(0, 1, old);
            }
            """));
    }

    [Test]
    public void HalfHasThirtyTwoBits()
    {
        ShaderBinary binary = Sandbox.Kernel("""
            half4 _H; RWStructuredBuffer<half3> _Out;
            [numthreads(1, 1, 1)] void CS() { _Out[0] = _H.xyz * _H.w; }
            """);
        Assert.That(Resource(binary, "_Out").Stride, Is.EqualTo(12));
        Assert.That(Resource(binary, "$Globals").Size, Is.EqualTo(16));
    }

    [TestCase("AppendStructuredBuffer<float> _B;", "_B.Append(1);")]
    [TestCase("RWStructuredBuffer<uint> _B;", "_B.IncrementCounter();")]
    public void HiddenCountersAreResourcesOfTheirOwn(string declaration, string use)
    {
        ShaderBinary binary = Sandbox.Kernel($"{declaration}\n[numthreads(1, 1, 1)] void CS() {{ {use} }}");
        Assert.That(Resource(binary, "_B@count").Kind, Is.EqualTo(ResourceKind.Counter));
    }

    [TestCase("RWBuffer<float> _B;", "_B[0] = 1;", "typed buffer")]
    public void WhatIsNotSupportedIsNamed(string declaration, string use, string expected)
    {
        var error = Assert.Throws<ShaderCompileException>(
            () => Sandbox.Kernel($"{declaration}\n[numthreads(1, 1, 1)] void CS() {{ {use} }}"));
        Assert.That(error!.Message, Does.Contain("'_B'").And.Contain(expected).And.Contain("Test.compute"));
    }
}
