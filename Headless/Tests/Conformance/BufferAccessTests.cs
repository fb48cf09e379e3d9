using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.Conformance;

/// <summary>Buffers, groupshared memory and functions as a user's compute shader has them.</summary>
public sealed class BufferAccessTests : HlslFixture
{
    [Test]
    public void ByteAddressBuffersLoadAndStoreSeveralWords()
    {
        using var raw = new GraphicsBuffer(GraphicsBuffer.Target.Raw, 16, 4);
        raw.SetData(new uint[16]);
        float[] found = Run(
            "RWByteAddressBuffer _Raw;",
            "_Raw.Store(0, 1); _Raw.Store2(4, uint2(2, 3)); _Raw.Store3(12, uint3(4, 5, 6)); _Raw.Store4(24, uint4(7, 8, 9, asuint(0.5))); "
            + "_Result[0] = _Raw.Load(4); _Result[1] = _Raw.Load2(8).y; _Result[2] = _Raw.Load3(12).z; _Result[3] = asfloat(_Raw.Load4(24).w);",
            4, shader => shader.SetBuffer(0, "_Raw", raw));
        Assert.That(found, Is.EqualTo(new[] { 2, 4, 6, 0.5f }));
    }

    [Test]
    public void GroupsharedStructsAndAtomicsAreSharedByTheGroup()
    {
        const string source = """
            struct Cell { float3 place; int count; };
            groupshared Cell cells[8];
            groupshared uint total;
            [numthreads(8, 1, 1)] void Main(uint t : SV_GroupIndex)
            {
                if (t == 0) total = 0;
                cells[t].place = float3(t, t * 2, t * 3);
                cells[t].count = (int)t - 4;
                GroupMemoryBarrierWithGroupSync();
                InterlockedAdd(total, t);
                InterlockedMin(cells[0].count, -9);
                GroupMemoryBarrierWithGroupSync();
                _Result[t] = t == 0 ? total : t == 1 ? cells[0].count : cells[7 - t].place.z;
            }
            """;
        Assert.That(RunKernel(source, 8), Is.EqualTo(new float[] { 28, -9, 15, 12, 9, 6, 3, 0 }));
    }

    [Test]
    public void IntegersDivideShiftAndConvertAsInDirect3D() =>
        Gives(
            [-3, -1, 3, 7, 31, 1.5f, -1, 4], "int n;",
            "_Result[0] = (-7 - n) / 2; _Result[1] = (-7 - n) % 2; _Result[2] = countbits(uint(7 + n)); _Result[3] = firstbithigh(uint(128 + n)); "
            + "_Result[4] = reversebits(1u + n) >> 26 == 32 ? 31 : 0; _Result[5] = fmod(5.5, 2 + n); _Result[6] = (-7 - n) >> 3; "
            + "_Result[7] = (int)(4.9 + n);");

    [TestCase("5.5", "2", 1.5f)]
    [TestCase("-5.5", "2", -1.5f)]
    [TestCase("5.5", "-2", 1.5f)]
    [TestCase("-5.5", "-2", -1.5f)]
    [TestCase("-6.0", "2", 0f)]
    [TestCase("-0.75", "0.5", -0.25f)]
    [TestCase("-1e2", "8", -4f)]
    public void FloatRemaindersHaveTheDividendsSign(string a, string b, float expected)
    {
        // Of uniforms, of both together in vectors, of constants that the compiler folds, and assigned.
        string[] remainders =
        [
            $"fmod({a} + n, {b} + n)", $"({a} + n) % ({b} + n)", $"fmod(float2(n, {a}), float2(1, {b} + n)).y",
            $"(float3(n, n, {a}) % float3(7, 7, {b})).z", $"fmod({a}, {b})", $"{a} % {b}", $"{a} % float({b})", "A % (B)", "A % B", "K",
            "Modulo(A, B)", "MODULO(A, B)", $"fmod(float4({a}, 1, 1, 1), {b}).x", "(A + 0.0) % b", "(float4(1, A, A, 1) % B).y",
        ];
        string globals = $"float n; static const float A = {a}; static const float B = {b}; static const float K = fmod(A, B);\n"
            + "float Modulo(float a, float b) { a %= b; return a; }\n#define MODULO(a, b) fmod(a, b)\n";
        Gives(
            [.. remainders.Select(_ => expected)], globals,
            $"const float b = {b}; " + string.Concat(remainders.Select((r, i) => $"_Result[{i}] = {r}; ")));
    }

    [Test]
    public void HalvesPackAndUnpack() =>
        Gives([1.5f, 15872], "", "_Result[0] = f16tof32(f32tof16(1.5)); _Result[1] = f32tof16(1.5);");

    [Test]
    public void FunctionsOverloadAndReturnThroughOutAndInoutParameters() =>
        Gives(
            [3, 10, 7], "struct S { float v; float Twice() { return v * 2; } }; void F(float a, out float b) { b = a + 1; } "
            + "void F(inout int c) { c += 2; } float G(float a, float b = 4) { return a + b; }",
            "float b; F(2.0, b); _Result[0] = b; S s; s.v = 5; _Result[1] = s.Twice(); int c = 1; F(c); _Result[2] = G(c);");

    [Test]
    public void MatricesMultiplyIndexAndSwizzleByRows() =>
        Gives(
            [17, 39, 3, 4], "",
            "float2x2 m = float2x2(1, 2, 3, 4); float2 v = mul(m, float2(5, 6)); _Result[0] = v.x; _Result[1] = v.y; _Result[2] = m[1].x; _Result[3] = m._22;");

    [Test]
    public void AConstantBufferIsBoundWhole()
    {
        using var constants = new GraphicsBuffer(GraphicsBuffer.Target.Constant, 2, 16);
        constants.SetData(new[] { new Vector4(1, 2, 3, 4), new Vector4(5, 6, 7, 8) });
        float[] found = Run(
            "cbuffer Block { float3 a; float b; float2 c; };", "_Result[0] = a.z; _Result[1] = b; _Result[2] = c.y;", 3,
            shader => shader.SetConstantBuffer("Block", constants, 0, 32));
        Assert.That(found, Is.EqualTo(new float[] { 3, 4, 6 }));
    }

    [Test]
    public void AChosenMipLevelIsWrittenAndAllAreRead()
    {
        var texture = new RenderTexture(new RenderTextureDescriptor(4, 4, RenderTextureFormat.RFloat, 0) { enableRandomWrite = true, useMipMap = true });
        texture.Create();
        ComputeShader write = Compute("#pragma kernel Main\nRWTexture2D<float> _Level; [numthreads(2, 2, 1)] void Main(uint2 id : SV_DispatchThreadID) { _Level[id] = 9; _Level[id] += 1; }");
        write.SetTexture(0, "_Level", texture, 1);
        write.Dispatch(0, 1, 1, 1);
        float[] found = Run("Texture2D<float> _All;", "_Result[0] = _All.Load(int3(1, 1, 1)); _Result[1] = _All.mips[1][uint2(0, 1)];", 2,
            shader => shader.SetTexture(0, "_All", texture));
        Assert.That(found, Is.EqualTo(new float[] { 10, 10 }));
    }
}
