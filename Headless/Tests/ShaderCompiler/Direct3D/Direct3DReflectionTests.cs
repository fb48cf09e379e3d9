using Headless.Shaders;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

/// <summary>What Direct3D's compiler says of a kernel's resources is what glslang's SPIR-V says.</summary>
public sealed class Direct3DReflectionTests
{
    private const string Buffers = """
        struct S { float3 p; uint n[2]; float2x3 m; };
        StructuredBuffer<S> _In; StructuredBuffer<float3> _Unused;
        RWStructuredBuffer<S> _Out; ByteAddressBuffer _Raw; RWByteAddressBuffer _RawOut;
        [numthreads(4, 2, 3)] void CS(uint3 id : SV_DispatchThreadID)
        {
            _RawOut.Store(id.x * 4, _Raw.Load(id.y * 4));
            _Out[id.x] = _In[id.y];
        }
        """;

    private const string Constants = """
        struct Inner { float3 a; float b; int2 c[2]; };
        struct Outer { Inner inner; float d; Inner more[2]; float3x2 m; };
        cbuffer Second : register(b2) { float2 _A; float3 _B; row_major float2x3 _R; float4x4 _M; bool _On; };
        cbuffer First { Outer _Outer; float _Tail[3]; Outer _Outers[2]; int3 _End; };
        uint _Count; float3 _Size; float2x3 _Matrices[3]; float _Last;
        RWStructuredBuffer<float> _Out;
        [numthreads(1, 1, 1)] void CS()
        {
            _Out[0] = _A.y + _B.x + _R[1][2] + _M[3][2] + _On + _Outer.more[1].c[1].y + _Outer.m[2][1] + _Tail[2];
            _Out[1] = _Outers[1].more[1].b + _End.z + _Count + _Size.z + _Matrices[2][1][2] + _Last;
        }
        """;

    private const string Textures = """
        Texture2D<float4> _A; Texture3D<uint> _B; Texture2DArray<int2> _C; TextureCube<float> _D;
        SamplerState sampler_A; SamplerState sampler_linear_clamp;
        RWTexture2D<float4> _E; RWTexture3D<uint> _F; RWStructuredBuffer<float> _Out;
        [numthreads(8, 8, 1)] void CS(uint3 id : SV_DispatchThreadID)
        {
            _E[id.xy] = _A.SampleLevel(sampler_A, id.xy, 0) + _D.SampleLevel(sampler_linear_clamp, (float3)id, 1);
            _F[id] = _B[id] + _C[id].y;
            _Out[id.x] = 1;
        }
        """;

    private const string Shared = """
        RWStructuredBuffer<uint> _Out; groupshared uint a[65]; groupshared float3 b[7];
        [numthreads(64, 1, 1)] void CS(uint i : SV_GroupIndex)
        {
            a[i] = i; b[i % 7] = i;
            GroupMemoryBarrierWithGroupSync();
            _Out[i] = a[63 - i] + b[(i + 3) % 7].y;
        }
        """;

    [TestCase(Buffers, TestName = "Buffers")]
    [TestCase(Constants, TestName = "Constant buffers")]
    [TestCase(Textures, TestName = "Textures and samplers")]
    [TestCase(Shared, TestName = "Group-shared memory")]
    public void IsThatOfGlslang(string source)
    {
        using ShaderSandbox plain = new();
        using ShaderSandbox direct3D = new() { Direct3D = Direct3DTools.Require() };

        ShaderBinary expected = plain.Kernel(source);
        ShaderBinary found = direct3D.Kernel(source);

        Assert.That(found.ByDirect3D, Is.True);
        Assert.That(Describe(found), Is.EqualTo(Describe(expected)));
        Assert.That(found.Resources.Select(r => r.Binding), Is.Unique);
    }

    // Numbers and formats are each compiler's own.
    private static IEnumerable<string> Describe(ShaderBinary binary)
    {
        yield return $"{binary.EntryPoint} {binary.GroupX} {binary.GroupY} {binary.GroupZ} {binary.SharedBytes}";
        foreach (ShaderResource r in binary.Resources.OrderBy(r => r.Name, StringComparer.Ordinal))
        {
            yield return $"{r.Name} {r.Kind} {r.Size} {r.Stride} {r.Dimension} {r.SampledType} {r.Comparison} {r.Count}";
            foreach (ConstantMember member in r.Members)
            {
                yield return $"{r.Name} {member}";
            }
        }
    }
}
