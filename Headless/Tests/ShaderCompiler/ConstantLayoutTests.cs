using Headless.Shaders;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

/// <summary>Offsets as fxc.exe 10.1 lists them for cs_5_0.</summary>
public sealed class ConstantLayoutTests : SandboxTests
{
    private const string Declarations = """
        struct Q { float3 a; };
        struct In { float x; Q q; float y; };
        cbuffer Params
        {
            float3 _A; float _B; float2 _Arr[3]; float _C; float3x3 _M3; float _D; Q _Q; float _E; int4 _I; bool _F;
            float2x4 _M24; float _G; row_major float2x3 _R; float3 _V; float2 _W; float _U; float _F4[2]; float2 _X;
            In _In[2]; float3 _Tail; float4x4 _MM[2]; double _DD; float _D1; double _D2;
        };
        RWStructuredBuffer<float> _Out;
        [numthreads(1, 1, 1)] void CS()
        {
            _Out[0] = _A.x + _Arr[1].y + _M3[1][2] + _Q.a.z + _M24[1][3] + _R[1][0] + _F4[1] + _In[1].q.a.y + _MM[1][2][3] + (float)_D2;
        }
        """;

    private static readonly (string Name, int Offset, int Size)[] Listed =
    [
        ("_A", 0, 12), ("_B", 12, 4), ("_Arr", 16, 40), ("_C", 56, 4), ("_M3", 64, 44), ("_D", 108, 4), ("_Q.a", 112, 12),
        ("_E", 124, 4), ("_I", 128, 16), ("_F", 144, 4), ("_M24", 160, 56), ("_G", 216, 4), ("_R", 224, 28),
        ("_V", 256, 12), ("_W", 272, 8), ("_U", 280, 4), ("_F4", 288, 20), ("_X", 308, 8), ("_In[0].x", 320, 4),
        ("_In[0].q.a", 336, 12), ("_In[0].y", 348, 4), ("_In[1].x", 352, 4), ("_In[1].q.a", 368, 12), ("_In[1].y", 380, 4),
        ("_Tail", 384, 12), ("_MM", 400, 128), ("_DD", 528, 8), ("_D1", 536, 4), ("_D2", 544, 8),
    ];

    [Test]
    public void EveryPackingRule()
    {
        ShaderResource buffer = Resource(Sandbox.Kernel(Declarations), "Params");
        Assert.That(buffer.Members.Select(m => (m.Name, m.Offset, m.Size)), Is.EqualTo(Listed));
        Assert.That(buffer.Size, Is.EqualTo(560));
    }

    [Test]
    public void ShapesForAUniformWriter()
    {
        IReadOnlyList<ConstantMember> members = Resource(Sandbox.Kernel(Declarations), "Params").Members;
        ConstantMember array = members.Single(m => m.Name == "_Arr");
        Assert.That((array.ArrayLength, array.ArrayStride, array.Columns, array.Type), Is.EqualTo((3, 16, 2, "float")));
        ConstantMember matrix = members.Single(m => m.Name == "_M24");
        Assert.That((matrix.IsMatrix, matrix.Rows, matrix.Columns, matrix.RowMajor), Is.EqualTo((true, 2, 4, false)));
        Assert.That(members.Single(m => m.Name == "_R").RowMajor, Is.True);
        Assert.That(members.Single(m => m.Name == "_MM").ArrayStride, Is.EqualTo(64));
        Assert.That(members.Single(m => m.Name == "_I").Type, Is.EqualTo("int"));
        Assert.That(members.Single(m => m.Name == "_DD").Type, Is.EqualTo("double"));
    }

    [Test]
    public void LooseGlobalsShareOneBuffer()
    {
        ShaderBinary binary = Sandbox.Kernel("""
            float3 _Unused; uint _Count; float4x4 _Matrix;
            RWStructuredBuffer<float4> _Out;
            [numthreads(1, 1, 1)] void CS() { _Out[_Count] = mul(_Matrix, float4(1, 2, 3, 1)); }
            """);
        ShaderResource globals = Resource(binary, "$Globals");
        Assert.That(globals.Members.Select(m => (m.Name, m.Offset)), Is.EqualTo(new[] { ("_Unused", 0), ("_Count", 12), ("_Matrix", 16) }));
        Assert.That(globals.Size, Is.EqualTo(80));
    }

    [Test]
    public void PackoffsetIsKept()
    {
        ShaderBinary binary = Sandbox.Kernel("""
            cbuffer Params { float _A : packoffset(c2.y); float2 _B : packoffset(c0); };
            RWStructuredBuffer<float> _Out;
            [numthreads(1, 1, 1)] void CS() { _Out[0] = _A + _B.y; }
            """);
        Assert.That(
            Resource(binary, "Params").Members.ToDictionary(m => m.Name, m => m.Offset),
            Is.EqualTo(new Dictionary<string, int> { ["_A"] = 36, ["_B"] = 0 }));
    }

    [Test]
    public void MatrixOfOneRowIsRefused()
    {
        var error = Assert.Throws<ShaderCompileException>(() => Sandbox.Kernel("""
            float1x3 _M;
            RWStructuredBuffer<float> _Out;
            [numthreads(1, 1, 1)] void CS() { _Out[0] = _M[0][1]; }
            """));
        Assert.That(error!.Message, Does.Contain("declare it as a vector"));
    }
}
