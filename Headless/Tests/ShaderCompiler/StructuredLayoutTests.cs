using Headless.Shaders;
using Headless.Shaders.SpirV;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

/// <summary>Strides and offsets as fxc.exe 10.1 lists them for cs_5_0.</summary>
public sealed class StructuredLayoutTests : SandboxTests
{
    [TestCase("float3", 12)]
    [TestCase("float", 4)]
    [TestCase("uint2", 8)]
    [TestCase("float3x3", 36)]
    [TestCase("float4x4", 64)]
    [TestCase("bool", 4)]
    public void ElementOfABuiltInType(string type, int stride)
    {
        ShaderBinary binary = Sandbox.Kernel($$"""
            StructuredBuffer<{{type}}> _In;
            RWStructuredBuffer<{{type}}> _Out;
            [numthreads(1, 1, 1)] void CS(uint3 id : SV_DispatchThreadID) { _Out[id.x] = _In[id.x]; }
            """);
        Assert.That(Resource(binary, "_In").Stride, Is.EqualTo(stride));
        Assert.That(Resource(binary, "_Out").Stride, Is.EqualTo(stride));
    }

    [TestCase("float3 a; float b;", new[] { 0, 12 }, 16)]
    [TestCase("float3 a; float3 b; float3 c;", new[] { 0, 12, 24 }, 36)]
    [TestCase("float2 a; float b[3]; float3x3 m; float c; double d;", new[] { 0, 8, 20, 56, 64 }, 72)]
    [TestCase("float2x3 m; Inner q[2]; bool f; row_major float3x2 r;", new[] { 0, 24, 48, 52 }, 76)]
    [TestCase("float a; double b; float c;", new[] { 0, 8, 16 }, 24)]
    [TestCase("Inner q; float x; Inner r[3]; uint2 y;", new[] { 0, 12, 16, 52 }, 60)]
    public void MembersOfAStruct(string members, int[] offsets, int stride)
    {
        ShaderBinary binary = Sandbox.Kernel($$"""
            struct Inner { float3 a; };
            struct Element { {{members}} };
            StructuredBuffer<Element> _In;
            RWStructuredBuffer<Element> _Out;
            [numthreads(1, 1, 1)] void CS(uint3 id : SV_DispatchThreadID) { _Out[id.x] = _In[id.x]; }
            """);
        Assert.That(Resource(binary, "_In").Stride, Is.EqualTo(stride));
        Assert.That(Resource(binary, "_Out").Stride, Is.EqualTo(stride));
        Assert.That(Offsets(binary, "_In"), Is.EqualTo(offsets));
        Assert.That(Offsets(binary, "_Out"), Is.EqualTo(offsets));
    }

    [Test]
    public void OneStructServesConstantBufferStructuredBufferAndSharedMemory()
    {
        ShaderBinary binary = Sandbox.Kernel("""
            struct Element { float2 a; float3 b; };
            cbuffer Params { Element _One; };
            RWStructuredBuffer<Element> _All;
            groupshared Element shared0[32];
            [numthreads(32, 1, 1)] void CS(uint i : SV_GroupIndex)
            {
                shared0[i] = _All[i];
                GroupMemoryBarrierWithGroupSync();
                Element e = shared0[31 - i];
                e.b += _One.b;
                _All[i] = e;
            }
            """);
        Assert.That(Resource(binary, "_All").Stride, Is.EqualTo(20));
        Assert.That(Resource(binary, "Params").Members.Select(m => m.Offset), Is.EqualTo(new[] { 0, 16 }));
        Assert.That(binary.SharedBytes, Is.EqualTo(32 * 20));
        Assert.That((binary.GroupX, binary.GroupY, binary.GroupZ), Is.EqualTo((32, 1, 1)));
    }

    [Test]
    public void GetDimensionsIsRefusedOnlyWhereItsStrideWouldBeWrong()
    {
        const string body = """
            StructuredBuffer<T> _In;
            RWStructuredBuffer<uint> _Out;
            [numthreads(1, 1, 1)] void CS() { uint n, s; _In.GetDimensions(n, s); _Out[0] = n * s; }
            """;
        Assert.DoesNotThrow(() => Sandbox.Kernel("#define T float4\n" + body));
        var error = Assert.Throws<ShaderCompileException>(() => Sandbox.Kernel("#define T float3\n" + body));
        Assert.That(error!.Message, Does.Contain("_In.GetDimensions"));
    }

    private static List<int> Offsets(ShaderBinary binary, string name)
    {
        SpirVIndex index = new(new SpirVModule(binary.SpirV));
        SpirVInstruction variable = index.Variables.Single(v => index.Name(v[1]) == name);
        uint array = index.Definition(index.Pointee(variable))[1];
        uint element = index.Definition(array)[1];
        int count = index.Definition(element).Operands.Length - 1;
        return [.. Enumerable.Range(0, count).Select(m => (int)index.Find(element, m, SpirVDecoration.Offset)![3])];
    }
}
