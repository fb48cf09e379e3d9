using Headless.Shaders;
using Headless.Shaders.SpirV;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

/// <summary>Stages of a pass: varyings are linked by semantic, system values, descriptor sets.</summary>
public sealed class StageTests : SandboxTests
{
    private const string Geometry = """
        #pragma vertex vert
        #pragma geometry geom
        #pragma fragment frag
        struct Particle { float3 position; uint id; float3 velocity; float pad0; float3 velocity1; float pad1; };
        StructuredBuffer<Particle> _Particles;
        float4x4 unity_MatrixVP;
        struct Point { uint index : TEXCOORD3; float2 extra : TEXCOORD1; };
        struct Corner { float4 position : SV_Position; float3 normal : NORMAL; float2 uv : TEXCOORD0; nointerpolation uint kind : BLENDINDICES; };
        struct Pixel { float2 uv : TEXCOORD0; float4 position : SV_Position; nointerpolation uint kind : BLENDINDICES; float3 normal : NORMAL0; bool front : SV_IsFrontFace; };
        Point vert(uint vertex : SV_VertexID)
        {
            Point o;
            o.index = vertex + (uint)_Particles[vertex].pad0;
            o.extra = 0;
            return o;
        }
        [maxvertexcount(15)]
        void geom(point Point input[1], inout TriangleStream<Corner> stream)
        {
            for (uint t = 0; t < 5; t++)
            {
                for (uint c = 0; c < 3; c++)
                {
                    Corner o;
                    o.position = mul(unity_MatrixVP, float4(_Particles[input[0].index + c].position, 1));
                    o.normal = _Particles[t].velocity + input[0].extra.x;
                    o.uv = c;
                    o.kind = t;
                    stream.Append(o);
                }
                stream.RestartStrip();
            }
        }
        float4 frag(Pixel i) : SV_Target { return float4(i.normal, i.uv.x) * _Particles[i.kind].velocity.x * (i.front ? 1 : i.position.w); }
        """;

    [Test]
    public void VertexGeometryAndFragmentAgree()
    {
        IReadOnlyList<ShaderBinary> stages = Sandbox.Pass(Geometry);
        Assert.That(stages.Select(s => s.Stage), Is.EqualTo(new[] { ShaderStage.Vertex, ShaderStage.Geometry, ShaderStage.Fragment }));
        Assert.That(stages.Select(s => s.DescriptorSet), Is.EqualTo(new[] { 0, 1, 2 }));
        Assert.That(stages[0].Inputs, Is.Empty);
        Assert.That(stages[1].InputPrimitive, Is.EqualTo("point"));
        foreach (ShaderBinary stage in stages)
        {
            Assert.That(Resource(stage, "_Particles").Stride, Is.EqualTo(48));
        }
        Assert.That(Locations(stages[1], "input."), Is.EqualTo(Locations(stages[0], "@entryPointOutput.")));
        Assert.That(Locations(stages[2], "i."), Is.EqualTo(Locations(stages[1], "stream.")));
    }

    [Test]
    public void VertexInputsCarryTheirSemantics()
    {
        IReadOnlyList<ShaderBinary> stages = Sandbox.Pass("""
            #pragma vertex vert
            #pragma fragment frag
            struct Input { float4 vertex : POSITION; float3 normal : normal; float2 uv : TEXCOORD; float4 uv1 : TEXCOORD1; uint4 bones : BLENDINDICES0; };
            float4 vert(Input v, uint instance : SV_InstanceID) : SV_Position { return v.vertex + v.normal.xyzz + v.uv.xyxy + v.uv1 + v.bones + instance; }
            float4 frag() : SV_Target { return 1; }
            """);
        Assert.That(stages[0].Inputs, Is.EqualTo(new[]
        {
            new VertexInput("POSITION", 0, 4, false),
            new VertexInput("NORMAL", 1, 3, false),
            new VertexInput("TEXCOORD0", 2, 2, false),
            new VertexInput("TEXCOORD1", 3, 4, false),
            new VertexInput("BLENDINDICES", 4, 4, true),
        }));
    }

    [Test]
    public void TargetsAndDepth()
    {
        IReadOnlyList<ShaderBinary> stages = Sandbox.Pass("""
            #pragma vertex vert
            #pragma fragment frag
            float4 vert(uint id : SV_VertexID) : SV_Position { return id; }
            struct Output { float4 second : SV_Target1; float4 first : SV_Target; float depth : SV_Depth; };
            Output frag(float4 p : SV_Position) { Output o; o.first = p; o.second = 1; o.depth = p.z; return o; }
            """);
        Dictionary<string, uint> locations = Locations(stages[1], "@entryPointOutput.");
        Assert.That(locations, Is.EqualTo(new Dictionary<string, uint> { ["first"] = 0, ["second"] = 1 }));
    }

    [TestCase("float2 uv : TEXCOORD1", "reads semantic TEXCOORD1, which the Vertex stage does not write")]
    [TestCase("float4 uv : TEXCOORD0", "float2 in the Vertex stage but float4 in the Fragment stage")]
    [TestCase("nointerpolation uint2 uv : TEXCOORD0", "float2 in the Vertex stage but uint2 in the Fragment stage")]
    public void DisagreementIsAnError(string input, string expected)
    {
        var error = Assert.Throws<ShaderCompileException>(() => Sandbox.Pass($$"""
            #pragma vertex vert
            #pragma fragment frag
            struct V { float4 position : SV_Position; float2 uv : TEXCOORD0; };
            V vert() { V o; o.position = 0; o.uv = 0; return o; }
            float4 frag({{input}}) : SV_Target { return float4(uv.xyxy); }
            """));
        Assert.That(error!.Message, Does.Contain(expected));
    }

    [Test]
    public void LegacySamplersBecomeTextureAndSampler()
    {
        IReadOnlyList<ShaderBinary> stages = Sandbox.Pass("""
            #pragma vertex vert
            #pragma fragment frag
            sampler2D _MainTex, _Other; samplerCUBE _Sky;
            SamplerComparisonState sampler_Shadow; Texture2D _Shadow;
            float4 vert() : SV_Position { return tex2Dlod(_MainTex, float4(0, 0, 0, 1)); }
            float4 frag(float4 p : SV_Position) : SV_Target
            {
                return tex2D(_Other, p.xy) + texCUBE(_Sky, p.xyz) + _Shadow.SampleCmpLevelZero(sampler_Shadow, p.xy, p.z);
            }
            """);
        Assert.That(stages[0].Resources.Select(r => r.Name), Is.EquivalentTo(new[] { "_MainTex", "sampler_MainTex" }));
        Assert.That(
            stages[1].Resources.Select(r => r.Name),
            Is.EquivalentTo(new[] { "_Other", "sampler_Other", "_Sky", "sampler_Sky", "_Shadow", "sampler_Shadow" }));
        Assert.That(Resource(stages[1], "_Sky").Dimension, Is.EqualTo("Cube"));
        Assert.That(stages[1].Resources.Where(r => r.Comparison).Select(r => r.Name), Is.EqualTo(new[] { "sampler_Shadow" }));
    }

    [Test]
    public void SemanticsOfDirect3D9()
    {
        IReadOnlyList<ShaderBinary> stages = Sandbox.Pass("""
            #pragma vertex vert
            #pragma fragment frag
            struct V { float4 position : POSITION; float2 uv : TEXCOORD0; };
            V vert(float4 p : POSITION) { V o; o.position = p; o.uv = 0; return o; }
            float4 frag(V i) : COLOR { return i.uv.xyxy; }
            """);
        SpirVIndex vertex = new(new SpirVModule(stages[0].SpirV));
        uint position = vertex.Variables.Single(v => vertex.Name(v[1]) == "@entryPointOutput.position")[1];
        Assert.That(vertex.Find(position, SpirVDecoration.BuiltIn)![2], Is.Zero);
        Assert.That(vertex.Find(position, SpirVDecoration.Location), Is.Null);
    }

    [Test]
    public void MatrixSwizzles()
    {
        Assert.DoesNotThrow(() => Sandbox.Pass("""
            #pragma vertex vert
            #pragma fragment frag
            float4x4 _M; float3x3 _A[2]; struct S { float4x4 m; }; StructuredBuffer<S> _S;
            float4 vert(uint id : SV_VertexID) : SV_Position { return float4(_M._m00_m10_m20, 1) + _M._11_22_33_44; }
            float4 frag() : SV_Target
            {
                float4x4 m = 0;
                m._m00_m11 = float2(1, 2);
                return mul(m, float4(_A[1]._m20_m21, _S[0].m._m00_m01));
            }
            """));
    }

    /// <summary>Location by the part of the variable's name after a prefix.</summary>
    private static Dictionary<string, uint> Locations(ShaderBinary binary, string prefix)
    {
        SpirVIndex index = new(new SpirVModule(binary.SpirV));
        Dictionary<string, uint> found = [];
        foreach (SpirVInstruction variable in index.Variables)
        {
            string name = index.Name(variable[1]);
            if (name.StartsWith(prefix, StringComparison.Ordinal) && index.Find(variable[1], SpirVDecoration.Location) is { } location)
            {
                found.Add(name[prefix.Length..], location[2]);
            }
        }
        return found;
    }
}
