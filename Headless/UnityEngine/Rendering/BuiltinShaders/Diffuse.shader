// Stand-in for Legacy Shaders/Diffuse: Lambert with ambient, one shadowed sun and further lights pass by pass.
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

        HLSLINCLUDE
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
            float3 world : TEXCOORD2;
            float3 vertexLight : TEXCOORD3;
            SHADOW_COORDS(4)
        };

        Varyings Vertex(appdata_base v)
        {
            Varyings o;
            o.pos = UnityObjectToClipPos(v.vertex);
            o.normal = UnityObjectToWorldNormal(v.normal);
            o.uv = v.texcoord.xy * _MainTex_ST.xy + _MainTex_ST.zw;
            o.world = mul(unity_ObjectToWorld, v.vertex).xyz;
            o.vertexLight = 0;
        #ifdef VERTEXLIGHT_ON
            o.vertexLight = Shade4PointLights(
                unity_4LightPosX0, unity_4LightPosY0, unity_4LightPosZ0,
                unity_LightColor[0].rgb, unity_LightColor[1].rgb, unity_LightColor[2].rgb, unity_LightColor[3].rgb,
                unity_4LightAtten0, o.world, o.normal);
        #endif
            TRANSFER_SHADOW(o)
            return o;
        }

        float4 Fragment(Varyings i) : SV_Target
        {
            float4 albedo = _MainTex.Sample(sampler_MainTex, i.uv) * _Color;
            float3 n = normalize(i.normal);
            UNITY_LIGHT_ATTENUATION(visible, i, i.world)
            float3 light = _LightColor0.rgb * saturate(dot(n, normalize(UnityWorldSpaceLightDir(i.world)))) * visible;
        #ifndef UNITY_PASS_FORWARDADD
            light += i.vertexLight + max(ShadeSH9(half4(n, 1)), 0);
        #endif
            return float4(albedo.rgb * light, albedo.a);
        }
        ENDHLSL

        Pass
        {
            Name "FORWARD"
            Tags { "LightMode" = "ForwardBase" }

            HLSLPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile_fwdbase
            ENDHLSL
        }

        Pass
        {
            Name "FORWARD_DELTA"
            Tags { "LightMode" = "ForwardAdd" }
            Blend One One
            ZWrite Off

            HLSLPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile_fwdadd
            ENDHLSL
        }

        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }

            HLSLPROGRAM
            #pragma vertex ShadowVertex
            #pragma fragment ShadowFragment

            float4 ShadowVertex(appdata_base v) : SV_POSITION
            {
                return UnityApplyLinearShadowBias(UnityClipSpaceShadowCasterPos(v.vertex, v.normal));
            }

            float4 ShadowFragment() : SV_Target
            {
                return 0;
            }
            ENDHLSL
        }
    }
}
