// Stand-in for Legacy Shaders/Diffuse: Lambert with ambient and one shadowed sun.
Shader "Legacy Shaders/Diffuse"
{
    Properties
    {
        _Color ("Main Color", Color) = (1, 1, 1, 1)
        _MainTex ("Base (RGB)", 2D) = "white" {}
    }
    SubShader
    {
        Tags { "RenderType" = "Opaque" }

        Pass
        {
            Name "FORWARD"
            Tags { "LightMode" = "ForwardBase" }

            HLSLPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile_fwdbase
            #include "UnityCG.cginc"
            #include "AutoLight.cginc"

            Texture2D _MainTex;
            SamplerState sampler_MainTex;
            float4 _MainTex_ST;
            float4 _Color;
            float4 _LightColor0;

            struct Varyings
            {
                float4 pos : SV_POSITION;
                float3 normal : TEXCOORD0;
                float2 uv : TEXCOORD1;
                SHADOW_COORDS(2)
            };

            Varyings Vertex(appdata_base v)
            {
                Varyings o;
                o.pos = UnityObjectToClipPos(v.vertex);
                o.normal = UnityObjectToWorldNormal(v.normal);
                o.uv = v.texcoord.xy * _MainTex_ST.xy + _MainTex_ST.zw;
                TRANSFER_SHADOW(o)
                return o;
            }

            float4 Fragment(Varyings i) : SV_Target
            {
                float4 albedo = _MainTex.Sample(sampler_MainTex, i.uv) * _Color;
                float3 n = normalize(i.normal);
                float3 sun = _LightColor0.rgb * saturate(dot(n, _WorldSpaceLightPos0.xyz)) * SHADOW_ATTENUATION(i);
                return float4(albedo.rgb * (sun + max(ShadeSH9(half4(n, 1)), 0)), albedo.a);
            }
            ENDHLSL
        }

        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }

            HLSLPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment
            #include "UnityCG.cginc"

            float4 Vertex(appdata_base v) : SV_POSITION
            {
                return UnityApplyLinearShadowBias(UnityClipSpaceShadowCasterPos(v.vertex, v.normal));
            }

            float4 Fragment() : SV_Target
            {
                return 0;
            }
            ENDHLSL
        }
    }
}
