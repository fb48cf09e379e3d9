// Stand-in for Unity's Standard: GGX highlights, Lambert, ambient from the sky, one shadowed sun, further lights pass by pass.
Shader "Standard"
{
    Properties
    {
        _Color ("Color", Color) = (1, 1, 1, 1)
        _MainTex ("Albedo", 2D) = "white" {}
        _Cutoff ("Alpha Cutoff", Range(0, 1)) = 0.5
        _Glossiness ("Smoothness", Range(0, 1)) = 0.5
        [Gamma] _Metallic ("Metallic", Range(0, 1)) = 0
        _BumpScale ("Scale", Float) = 1
        _BumpMap ("Normal Map", 2D) = "bump" {}
        _OcclusionStrength ("Strength", Range(0, 1)) = 1
        _OcclusionMap ("Occlusion", 2D) = "white" {}
        [HDR] _EmissionColor ("Emission", Color) = (0, 0, 0, 1)
        _EmissionMap ("Emission", 2D) = "white" {}
        _Mode ("Mode", Float) = 0
        _SrcBlend ("Source Blend", Float) = 1
        _DstBlend ("Destination Blend", Float) = 0
        _ZWrite ("Z Write", Float) = 1
    }
    SubShader
    {
        Tags { "RenderType" = "Opaque" }

        HLSLINCLUDE
        #include "UnityCG.cginc"
        #include "AutoLight.cginc"

        Texture2D _MainTex;
        SamplerState sampler_MainTex;
        Texture2D _BumpMap;
        SamplerState sampler_BumpMap;
        Texture2D _OcclusionMap;
        SamplerState sampler_OcclusionMap;
        Texture2D _EmissionMap;
        SamplerState sampler_EmissionMap;
        float4 _MainTex_ST;
        float4 _Color;
        float4 _EmissionColor;
        float4 _LightColor0;
        float _Cutoff;
        float _Glossiness;
        float _Metallic;
        float _BumpScale;
        float _OcclusionStrength;

        struct Attributes
        {
            float4 position : POSITION;
            float3 normal : NORMAL;
            float4 tangent : TANGENT;
            float2 uv : TEXCOORD0;
        };

        struct Varyings
        {
            float4 position : SV_POSITION;
            float3 world : TEXCOORD0;
            float3 normal : TEXCOORD1;
            float4 tangent : TEXCOORD2;
            float2 uv : TEXCOORD3;
            float3 vertexLight : TEXCOORD4;
        };

        Varyings Vertex(Attributes v)
        {
            Varyings o;
            o.world = mul(unity_ObjectToWorld, float4(v.position.xyz, 1)).xyz;
            o.position = mul(unity_MatrixVP, float4(o.world, 1));
            o.normal = UnityObjectToWorldNormal(v.normal);
            o.tangent = float4(UnityObjectToWorldDir(v.tangent.xyz), v.tangent.w * unity_WorldTransformParams.w);
            o.uv = v.uv * _MainTex_ST.xy + _MainTex_ST.zw;
            o.vertexLight = 0;
        #ifdef VERTEXLIGHT_ON
            o.vertexLight = Shade4PointLights(
                unity_4LightPosX0, unity_4LightPosY0, unity_4LightPosZ0,
                unity_LightColor[0].rgb, unity_LightColor[1].rgb, unity_LightColor[2].rgb, unity_LightColor[3].rgb,
                unity_4LightAtten0, o.world, o.normal);
        #endif
            return o;
        }

        float SunVisibility(float3 world, float3 normal, float3 light)
        {
        #ifdef SHADOWS_SCREEN
            // Nine bilinear comparisons over 3 x 3 texels, from a point a little off the surface.
            float width;
            float height;
            _ShadowMapTexture.GetDimensions(width, height);
            float2 texel = 1.0 / float2(width, height);
            float slope = sqrt(saturate(1 - dot(normal, light) * dot(normal, light)));
            float metres = texel.x / length(unity_WorldToShadow[0][0].xyz);
            float3 coord = mul(unity_WorldToShadow[0], float4(world + normal * (2.0 * metres * slope), 1)).xyz;
            float sum = 0;
            [unroll]
            for (int y = -1; y <= 1; y++)
            {
                [unroll]
                for (int x = -1; x <= 1; x++)
                {
                    sum += _ShadowMapTexture.SampleCmpLevelZero(sampler_ShadowMapTexture, coord.xy + float2(x, y) * texel, coord.z);
                }
            }
            bool outside = any(coord.xy < 0) || any(coord.xy > 1);
            return outside ? 1.0 : lerp(_LightShadowData.x, 1.0, sum / 9.0);
        #else
            return 1;
        #endif
        }

        float3 Shade(float3 n, float3 v, float3 l, float3 diffuse, float3 specular, float roughness)
        {
            float3 h = normalize(l + v);
            float nl = saturate(dot(n, l));
            float nh = saturate(dot(n, h));
            float lh = saturate(dot(l, h));
            float nv = saturate(dot(n, v)) + 1e-4;
            float a = max(roughness * roughness, 0.002);
            float a2 = a * a;
            float d = a2 / (UNITY_PI * pow(nh * nh * (a2 - 1) + 1, 2) + 1e-7);
            float visibility = 0.5 / (nl * (nv * (1 - a) + a) + nv * (nl * (1 - a) + a) + 1e-5);
            float3 fresnel = specular + (1 - specular) * pow(1 - lh, 5);
            return (diffuse + fresnel * (visibility * d * UNITY_PI)) * nl;
        }

        float4 Fragment(Varyings i, bool front : SV_IsFrontFace) : SV_Target
        {
            float4 albedo = _MainTex.Sample(sampler_MainTex, i.uv) * _Color;
        #ifdef _ALPHATEST_ON
            clip(albedo.a - _Cutoff);
        #endif
            float3 n = normalize(i.normal);
        #ifdef _NORMALMAP
            float3 bump = UnpackNormal(_BumpMap.Sample(sampler_BumpMap, i.uv));
            float3 tangent = normalize(i.tangent.xyz);
            float3 binormal = cross(n, tangent) * i.tangent.w;
            n = normalize(tangent * bump.x * _BumpScale + binormal * bump.y * _BumpScale + n * bump.z);
        #endif
            n = front ? n : -n;
            float3 v = normalize(_WorldSpaceCameraPos - i.world);
            float3 light = normalize(UnityWorldSpaceLightDir(i.world));
            float roughness = 1 - _Glossiness;
            float reflectivity = 0.04 + 0.96 * _Metallic;
            float3 specular = lerp(float3(0.04, 0.04, 0.04), albedo.rgb, _Metallic);
            float3 diffuse = albedo.rgb * (1 - reflectivity);
            float occlusion = lerp(1, _OcclusionMap.Sample(sampler_OcclusionMap, i.uv).g, _OcclusionStrength);
        #ifdef _ALPHAPREMULTIPLY_ON
            diffuse *= albedo.a;
            albedo.a = 1 - (1 - reflectivity) * (1 - albedo.a);
        #endif

        #ifdef UNITY_PASS_FORWARDADD
            UNITY_LIGHT_ATTENUATION(visible, i, i.world)
            return float4(Shade(n, v, light, diffuse, specular, roughness) * _LightColor0.rgb * visible, albedo.a);
        #else
            float sun = SunVisibility(i.world, normalize(i.normal), light);
            float3 color = Shade(n, v, light, diffuse, specular, roughness) * _LightColor0.rgb * sun;
            color += diffuse * i.vertexLight;

            // The sky stands in for reflection probes.
            float3 mirrored = reflect(-v, n);
            float3 sky = max(ShadeSH9(half4(lerp(n, mirrored, _Glossiness), 1)), 0);
            float3 edge = specular + (max(_Glossiness, specular) - specular) * pow(1 - saturate(dot(n, v)), 5);
            color += (diffuse * max(ShadeSH9(half4(n, 1)), 0) + edge * sky / (1 + roughness * roughness)) * occlusion;
        #ifdef _EMISSION
            color += _EmissionMap.Sample(sampler_EmissionMap, i.uv).rgb * _EmissionColor.rgb;
        #endif
            return float4(color, albedo.a);
        #endif
        }
        ENDHLSL

        Pass
        {
            Name "FORWARD"
            Tags { "LightMode" = "ForwardBase" }
            Blend [_SrcBlend] [_DstBlend]
            ZWrite [_ZWrite]

            HLSLPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma target 4.5
            #pragma multi_compile_fwdbase
            #pragma shader_feature_local _ALPHATEST_ON
            #pragma shader_feature_local _ALPHAPREMULTIPLY_ON
            #pragma shader_feature_local _NORMALMAP
            #pragma shader_feature _EMISSION
            ENDHLSL
        }

        Pass
        {
            Name "FORWARD_DELTA"
            Tags { "LightMode" = "ForwardAdd" }
            Blend [_SrcBlend] One
            ZWrite Off
            ZTest LEqual

            HLSLPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma target 4.5
            #pragma multi_compile_fwdadd_fullshadows
            #pragma shader_feature_local _ALPHATEST_ON
            #pragma shader_feature_local _ALPHAPREMULTIPLY_ON
            #pragma shader_feature_local _NORMALMAP
            ENDHLSL
        }

        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            ZWrite On
            Cull Off

            HLSLPROGRAM
            #pragma vertex ShadowVertex
            #pragma fragment ShadowFragment
            #pragma target 4.5
            #pragma shader_feature_local _ALPHATEST_ON

            struct ShadowVaryings
            {
                float4 position : SV_POSITION;
                float2 uv : TEXCOORD0;
            };

            ShadowVaryings ShadowVertex(Attributes v)
            {
                ShadowVaryings o;
                o.position = UnityApplyLinearShadowBias(UnityClipSpaceShadowCasterPos(v.position, v.normal));
                o.uv = v.uv * _MainTex_ST.xy + _MainTex_ST.zw;
                return o;
            }

            float4 ShadowFragment(ShadowVaryings i) : SV_Target
            {
            #ifdef _ALPHATEST_ON
                clip(_MainTex.Sample(sampler_MainTex, i.uv).a * _Color.a - _Cutoff);
            #endif
                return 0;
            }
            ENDHLSL
        }
    }
}
