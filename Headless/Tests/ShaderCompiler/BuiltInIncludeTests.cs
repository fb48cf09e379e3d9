using Headless.Shaders;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

/// <summary>Shaders as people write them against UnityCG.cginc.</summary>
public sealed class BuiltInIncludeTests : SandboxTests
{
    private const string Lit = """
        Shader "Lit" { Properties { _MainTex ("t", 2D) = "white" {} } SubShader {
        Pass { Tags { "LightMode" = "ForwardBase" }
            CGPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #pragma multi_compile_fwdbase
            #pragma multi_compile_fog
            #include "Lighting.cginc"
            #include "AutoLight.cginc"
            #ifndef UNITY_PASS_FORWARDBASE
            #error No UNITY_PASS_FORWARDBASE
            #endif
            sampler2D _MainTex; float4 _MainTex_ST; fixed4 _Color;
            struct v2f { float4 pos : SV_POSITION; half2 uv : TEXCOORD0; float3 n : TEXCOORD1; SHADOW_COORDS(2) UNITY_FOG_COORDS(3) };
            v2f vert(appdata_full v)
            {
                v2f o;
                UNITY_INITIALIZE_OUTPUT(v2f, o)
                o.pos = UnityObjectToClipPos(v.vertex);
                o.uv = TRANSFORM_TEX(v.texcoord, _MainTex);
                o.n = UnityObjectToWorldNormal(v.normal);
                TRANSFER_SHADOW(o)
                UNITY_TRANSFER_FOG(o, o.pos);
                return o;
            }
            fixed4 frag(v2f i) : SV_Target
            {
                fixed4 c = tex2D(_MainTex, i.uv) * _Color;
                fixed diffuse = max(0, dot(i.n, normalize(_WorldSpaceLightPos0.xyz)));
                c.rgb *= _LightColor0.rgb * diffuse * SHADOW_ATTENUATION(i) + ShadeSH9(half4(i.n, 1));
                UNITY_APPLY_FOG(i.fogCoord, c);
                return c * Luminance(c.rgb) + LinearEyeDepth(i.pos.z) * _Time.y;
            }
            ENDCG
        }
        Pass { Name "ShadowCaster" Tags { "LightMode" = "ShadowCaster" }
            CGPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #pragma multi_compile_shadowcaster
            #include "UnityCG.cginc"
            struct v2f { V2F_SHADOW_CASTER; };
            v2f vert(appdata_base v) { v2f o; TRANSFER_SHADOW_CASTER_NORMALOFFSET(o) return o; }
            float4 frag(v2f i) : SV_Target { SHADOW_CASTER_FRAGMENT(i) }
            ENDCG
        } } }
        """;

    [TestCase(new string[0], false)]
    [TestCase(new[] { "SHADOWS_SCREEN" }, true)]
    public void ForwardPass(string[] keywords, bool shadows)
    {
        IReadOnlyList<ShaderBinary> stages = Compile(0, keywords);
        Assert.That(stages[1].Resources.Any(r => r.Name == "_ShadowMapTexture"), Is.EqualTo(shadows));
        Assert.That(Resource(stages[0], "UnityPerDraw").Members[0].Name, Is.EqualTo("unity_ObjectToWorld"));
        Assert.That(stages[0].Inputs.Select(i => i.Semantic), Does.Contain("POSITION").And.Contain("NORMAL").And.Contain("TEXCOORD0"));
    }

    [Test]
    public void ShadowCasterPass() => Assert.That(Compile(1, []), Has.Count.EqualTo(2));

    private IReadOnlyList<ShaderBinary> Compile(int pass, string[] keywords)
    {
        ShaderLabSource source = ShaderLabSource.Parse(Sandbox.Add("Assets/Lit.shader", Lit), Sandbox.Includes);
        IReadOnlyList<ShaderBinary> stages = Sandbox.Compiler().CompilePass(source.SubShaders[0].Passes[pass], keywords);
        foreach (ShaderBinary stage in stages)
        {
            ShaderSandbox.Validate(stage);
        }
        return stages;
    }
}
