using Headless.Shaders;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

public sealed class ShaderLabTests : SandboxTests
{
    private const string Program = """
        HLSLPROGRAM
        #pragma vertex vert
        #pragma fragment frag
        float4 vert() : SV_Position { return 0; }
        float4 frag() : SV_Target { return 1; }
        ENDHLSL
        """;

    private ShaderLabSource Parse(string text) => ShaderLabSource.Parse(Sandbox.Add("Assets/S.shader", text), Sandbox.Includes);

    private RenderState State(string commands) =>
        Parse($"Shader \"S\" {{ SubShader {{ Pass {{ {commands}\n{Program} }} }} }}").SubShaders[0].Passes[0].State;

    [Test]
    public void Properties()
    {
        ShaderLabSource source = Parse("""
            // comment } "
            Shader "Folder/Odd"{Properties{_MainTex("A /* no comment */ name",2D)="white"{} [HDR][Gamma]_Color("c",Color)=(1,.5,-1e-2)
              [Enum(Off,0,On,1)] _Cull ("Cull", Int)=2 /* between
              lines */ _Range("r", range(-1.5, 2.0))=.25
              _Vector ("v", Vector) = (1,2,3) _Cube("k", CUBE) = "" {} _Volume ("3", 3D) = "black" { TexGen Nothing }
              [KeywordEnum(None, Add Some)] _Mode ("m", Integer) = -3 }
            SubShader{} FallBack Off CustomEditor "X.Y" }
            """.Replace("Add Some", "Some"));
        Assert.That(source.Name, Is.EqualTo("Folder/Odd"));
        Assert.That(source.Fallback, Is.Empty);
        Assert.That(source.Properties.Select(p => (p.Name, p.Type)), Is.EqualTo(new[]
        {
            ("_MainTex", ShaderPropertyType.Texture2D), ("_Color", ShaderPropertyType.Color), ("_Cull", ShaderPropertyType.Float),
            ("_Range", ShaderPropertyType.Range), ("_Vector", ShaderPropertyType.Vector), ("_Cube", ShaderPropertyType.TextureCube),
            ("_Volume", ShaderPropertyType.Texture3D), ("_Mode", ShaderPropertyType.Integer),
        }));
        Assert.That(source.Properties[0].Display, Is.EqualTo("A /* no comment */ name"));
        Assert.That(source.Properties[0].DefaultTexture, Is.EqualTo("white"));
        Assert.That(source.Properties[1].Default, Is.EqualTo(new[] { 1f, 0.5f, -0.01f, 1f }));
        Assert.That(source.Properties[1].Attributes, Is.EqualTo(new[] { "HDR", "Gamma" }));
        Assert.That(source.Properties[2].Attributes, Is.EqualTo(new[] { "Enum(Off, 0, On, 1)" }));
        Assert.That((source.Properties[3].RangeMin, source.Properties[3].RangeMax), Is.EqualTo((-1.5f, 2f)));
        Assert.That(source.Properties[4].Default, Is.EqualTo(new[] { 1f, 2f, 3f, 0f }));
    }

    [Test]
    public void PassesTagsAndInheritedState()
    {
        ShaderLabSource source = Parse($$"""
            Shader "S" { SubShader { Tags { "Queue" = "Transparent" "RenderPipeline"="UniversalPipeline" } LOD 200 Cull Off ZWrite off
            Pass { Name "A" Tags{"LightMode"="ForwardBase"} Cull Front {{Program}} }
            Pass { ZWRITE On {{Program}} } }
            SubShader { Pass { {{Program}} } } Fallback "Diffuse" }
            """);
        Assert.That(source.Fallback, Is.EqualTo("Diffuse"));
        SubShader first = source.SubShaders[0];
        Assert.That(first.Tags["renderpipeline"], Is.EqualTo("UniversalPipeline"));
        Assert.That(first.Lod, Is.EqualTo(200));
        Assert.That(first.Passes.Select(p => (p.Name, p.State.Cull.Value, p.State.ZWrite.Value)), Is.EqualTo(new[] { ("A", 1f, 0f), ("", 0f, 1f) }));
        Assert.That(first.Passes[0].Tags["LightMode"], Is.EqualTo("ForwardBase"));
        Assert.That(source.SubShaders[1].Passes[0].State, Is.EqualTo(new RenderState()));
    }

    [Test]
    public void RenderStates()
    {
        RenderState state = State("ZTest GEqual Offset -1.5, [_Units] ColorMask RGB Blend SrcAlpha OneMinusSrcAlpha, One Zero BlendOp Add, Max");
        Assert.That(state.ZTest, Is.EqualTo(new RenderStateValue(7)));
        Assert.That((state.OffsetFactor.Value, state.OffsetUnits.Property), Is.EqualTo((-1.5f, "_Units")));
        Assert.That(state.ColorMask.Value, Is.EqualTo(14));
        Assert.That(state.Blend, Is.True);
        Assert.That((state.SourceColor.Value, state.DestinationColor.Value), Is.EqualTo((5f, 10f)));
        Assert.That((state.SourceAlpha.Value, state.DestinationAlpha.Value), Is.EqualTo((1f, 0f)));
        Assert.That((state.BlendOpColor.Value, state.BlendOpAlpha.Value), Is.EqualTo((0f, 4f)));
    }

    [Test]
    public void StatesFromProperties()
    {
        RenderState state = State("Cull [_Cull] ZWrite [_ZWrite] ZTest[_ZTest] Blend [_Src] [_Dst] ColorMask [_Mask] BlendOp[_Op]");
        Assert.That(
            new[] { state.Cull, state.ZWrite, state.ZTest, state.SourceColor, state.DestinationColor, state.ColorMask, state.BlendOpColor }
                .Select(v => v.Property),
            Is.EqualTo(new[] { "_Cull", "_ZWrite", "_ZTest", "_Src", "_Dst", "_Mask", "_Op" }));
        Assert.That(State("Blend Off ColorMask 0").ColorMask.Value, Is.Zero);
    }

    [Test]
    public void PragmasOfAProgram()
    {
        ShaderProgram program = Parse("""
            Shader "S" { HLSLINCLUDE
            #pragma target 4.5
            ENDHLSL
            SubShader { Pass { HLSLPROGRAM
            #pragma vertex vert // trailing
            #pragma geometry geom
            #pragma fragment frag
            #pragma require 2darray : KEY
            #pragma shader_feature_local_fragment _ KEY
            #pragma multi_compile_instancing
            ENDHLSL } } }
            """).SubShaders[0].Passes[0].Program;
        Assert.That((program.Vertex, program.Geometry, program.Fragment, program.Target), Is.EqualTo(("vert", "geom", "frag", 45)));
        Assert.That(program.Requires, Does.Contain("geometry"));
        Assert.That(program.KeywordSets.Select(s => string.Join("|", s.Keywords)), Is.EqualTo(new[] { "|KEY", "|INSTANCING_ON" }));
    }

    [Test]
    public void LodAfterAPassAndInIt()
    {
        SubShader subShader = Parse($$"""Shader "S" { SubShader { Pass { LOD 100 Name "A" LOD 200 {{Program}} } LOD 300 } }""").SubShaders[0];
        Assert.That((subShader.Lod, subShader.Passes[0].Name), Is.EqualTo((300, "A")));
    }

    [Test]
    public void TargetsOfKeywordsAreForTheirVariants()
    {
        ShaderProgram program = Parse("""
            Shader "S" { SubShader { Pass { HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #pragma target 3.0
            #pragma target 4.5 KEY
            ENDHLSL } } }
            """).SubShaders[0].Passes[0].Program;
        Assert.That((program.Target, program.TargetOf([]), program.TargetOf(["OTHER", "KEY"])), Is.EqualTo((30, 30, 45)));
    }

    [TestCase("only_renderers metal vulkan", false)]
    [TestCase("only_renderers d3d11 vulkan", true)]
    [TestCase("exclude_renderers d3d11", false)]
    [TestCase("exclude_renderers gles3 glcore", true)]
    public void RenderersOfAProgram(string pragma, bool ours)
    {
        ShaderPass pass = Parse($$"""
            Shader "S" { SubShader { Pass { HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #pragma {{pragma}}
            float4 vert(float4 p : POSITION) : SV_Position { return p; }
            float4 frag() : SV_Target { return 1; }
            ENDHLSL } } }
            """).SubShaders[0].Passes[0];
        TestDelegate compile = () => Sandbox.Compiler().CompilePass(pass, []);
        if (ours)
        {
            Assert.DoesNotThrow(compile);
        }
        else
        {
            Assert.That(Assert.Throws<ShaderCompileException>(compile)!.Problem, Does.Contain("not for Direct3D 11"));
        }
    }

    [Test]
    public void UnmetPackageRequirementsSkipTheSubShader()
    {
        Sandbox.Add("Packages/tool/package.json", """{"name": "com.example.tool", "version": "1.4.2"}""");
        ShaderLabSource source = Parse($$"""
            Shader "S" {
            SubShader { PackageRequirements { "com.unity.render-pipelines.universal": "14.0" } LOD 1 Pass { {{Program}} } }
            SubShader { PackageRequirements { "com.example.tool": "[1.0,2.0)" "unity": "2022.3" } LOD 2 Pass { {{Program}} } }
            SubShader { PackageRequirements { "com.example.tool": "1.5" } LOD 3 Pass { {{Program}} } }
            SubShader { LOD 4 Pass { PackageRequirements { "com.none" } {{Program}} } Pass { {{Program}} } } }
            """);
        Assert.That(source.SubShaders.Select(s => s.Lod), Is.EqualTo(new[] { 2, 4 }));
        Assert.That(source.SubShaders[1].Passes, Has.Count.EqualTo(1));
    }

    [Test]
    public void CgProgramHasUnitysIncludesAndHlslProgramHasNone()
    {
        const string body = """

            #pragma vertex vert
            #pragma fragment frag
            float4 vert(float4 p : POSITION) : SV_Position { return mul(UNITY_MATRIX_VP, mul(unity_ObjectToWorld, p)); }
            fixed4 frag() : SV_Target { return 1; }

            """;
        ShaderPass cg = Parse($"Shader \"S\" {{ SubShader {{ Pass {{ CGPROGRAM{body}ENDCG }} }} }}").SubShaders[0].Passes[0];
        Assert.That(
            Sandbox.Compiler().CompilePass(cg, [])[0].Resources.Select(r => r.Name),
            Is.EquivalentTo(new[] { "UnityPerFrame", "UnityPerDraw" }));
        ShaderPass hlsl = Parse($"Shader \"S\" {{ SubShader {{ Pass {{ HLSLPROGRAM{body}ENDHLSL }} }} }}").SubShaders[0].Passes[0];
        Assert.Throws<ShaderCompileException>(() => Sandbox.Compiler().CompilePass(hlsl, []));
    }
}
