// Stand-in for URP's Lit: one sun with cascades, additional lights by object or by cluster, ambient probe, reflection probe. The BRDF is that of
// the pipeline's manual: GGX with the visibility and Fresnel terms of Karis' approximation for mobile devices.
Shader "Universal Render Pipeline/Lit"
{
    Properties
    {
        [MainTexture] _BaseMap ("Albedo", 2D) = "white" {}
        [MainColor] _BaseColor ("Color", Color) = (1, 1, 1, 1)
        _Cutoff ("Alpha Cutoff", Range(0, 1)) = 0.5
        _Smoothness ("Smoothness", Range(0, 1)) = 0.5
        _Metallic ("Metallic", Range(0, 1)) = 0
        _BumpScale ("Scale", Float) = 1
        _BumpMap ("Normal Map", 2D) = "bump" {}
        _OcclusionStrength ("Strength", Range(0, 1)) = 1
        _OcclusionMap ("Occlusion", 2D) = "white" {}
        [HDR] _EmissionColor ("Emission", Color) = (0, 0, 0, 1)
        _EmissionMap ("Emission", 2D) = "white" {}
        _Surface ("Surface", Float) = 0
        _Cull ("Cull", Float) = 2
        _SrcBlend ("Source Blend", Float) = 1
        _DstBlend ("Destination Blend", Float) = 0
        _ZWrite ("Z Write", Float) = 1
        [HideInInspector] _MainTex ("Albedo", 2D) = "white" {}
        [HideInInspector] _Color ("Color", Color) = (1, 1, 1, 1)
    }

    HLSLINCLUDE
    #pragma target 4.5

    float4x4 unity_ObjectToWorld;
    float4x4 unity_WorldToObject;
    float4 unity_WorldTransformParams;
    float4x4 unity_MatrixVP;
    float4x4 unity_MatrixV;
    float3 _WorldSpaceCameraPos;
    float4 _ScaledScreenParams;
    float4 _ScaleBiasRt;
    float4 unity_OrthoParams;
    float4 unity_SHAr;
    float4 unity_SHAg;
    float4 unity_SHAb;
    float4 unity_SHBr;
    float4 unity_SHBg;
    float4 unity_SHBb;
    float4 unity_SHC;
    float4 unity_LightData;
    float4 unity_LightIndices[2];
    TextureCube<float4> unity_SpecCube0;
    float4 unity_SpecCube0_HDR;

    SamplerState sampler_LinearClamp;
    SamplerComparisonState sampler_LinearClampCompare;

    Texture2D<float4> _BaseMap;
    SamplerState sampler_BaseMap;
    Texture2D<float4> _BumpMap;
    SamplerState sampler_BumpMap;
    Texture2D<float4> _OcclusionMap;
    SamplerState sampler_OcclusionMap;
    Texture2D<float4> _EmissionMap;
    SamplerState sampler_EmissionMap;
    float4 _BaseMap_ST;
    float4 _BaseColor;
    float4 _EmissionColor;
    float _Cutoff;
    float _Smoothness;
    float _Metallic;
    float _BumpScale;
    float _OcclusionStrength;

    float4 _ShadowBias;
    float3 _LightDirection;
    float3 _LightPosition;

    struct Attributes
    {
        float3 position : POSITION;
        float3 normal : NORMAL;
        float4 tangent : TANGENT;
        float2 uv : TEXCOORD0;
    };

    struct Varyings
    {
        float4 clip : SV_Position;
        float3 world : TEXCOORD0;
        float3 normal : TEXCOORD1;
        float4 tangent : TEXCOORD2;
        float2 uv : TEXCOORD3;
    };

    Varyings Place(Attributes input)
    {
        Varyings output;
        output.world = mul(unity_ObjectToWorld, float4(input.position, 1.0)).xyz;
        output.clip = mul(unity_MatrixVP, float4(output.world, 1.0));
        output.normal = normalize(mul(input.normal, (float3x3)unity_WorldToObject));
        output.tangent = float4(mul((float3x3)unity_ObjectToWorld, input.tangent.xyz), input.tangent.w * unity_WorldTransformParams.w);
        output.uv = input.uv * _BaseMap_ST.xy + _BaseMap_ST.zw;
        return output;
    }

    float4 Albedo(float2 uv)
    {
        float4 albedo = _BaseMap.Sample(sampler_BaseMap, uv) * _BaseColor;
    #if defined(_ALPHATEST_ON)
        clip(albedo.a - _Cutoff);
    #endif
        return albedo;
    }

    float3 Normal(Varyings input)
    {
        float3 normal = normalize(input.normal);
    #if defined(_NORMALMAP)
        float3 bump = _BumpMap.Sample(sampler_BumpMap, input.uv).xyz * 2.0 - 1.0;
        bump.xy *= _BumpScale;
        float3 tangent = normalize(input.tangent.xyz);
        normal = normalize(bump.x * tangent + bump.y * cross(normal, tangent) * input.tangent.w + bump.z * normal);
    #endif
        return normal;
    }
    ENDHLSL

    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "RenderType" = "Opaque" "UniversalMaterialType" = "Lit" }

        Pass
        {
            Name "ForwardLit"
            Tags { "LightMode" = "UniversalForward" }
            Blend [_SrcBlend] [_DstBlend]
            ZWrite [_ZWrite]
            Cull [_Cull]

            HLSLPROGRAM
            #pragma vertex Place
            #pragma fragment Shade
            #pragma multi_compile _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_CASCADE
            #pragma multi_compile _ _ADDITIONAL_LIGHTS
            #pragma multi_compile _ _FORWARD_PLUS
            #pragma multi_compile_fragment _ _ADDITIONAL_LIGHT_SHADOWS
            #pragma multi_compile_fragment _ _SHADOWS_SOFT
            #pragma shader_feature_local _NORMALMAP
            #pragma shader_feature_local _ALPHATEST_ON
            #pragma shader_feature_local _EMISSION
            #pragma shader_feature_local _RECEIVE_SHADOWS_OFF

            #define MAX_LIGHTS 256

            float4 _MainLightPosition;
            float4 _MainLightColor;
            float4 _AdditionalLightsCount;
            float4 _AdditionalLightsPosition[MAX_LIGHTS];
            float4 _AdditionalLightsColor[MAX_LIGHTS];
            float4 _AdditionalLightsAttenuation[MAX_LIGHTS];
            float4 _AdditionalLightsSpotDir[MAX_LIGHTS];
            float4x4 _MainLightWorldToShadow[5];
            float4 _CascadeShadowSplitSpheres0;
            float4 _CascadeShadowSplitSpheres1;
            float4 _CascadeShadowSplitSpheres2;
            float4 _CascadeShadowSplitSpheres3;
            float4 _CascadeShadowSplitSphereRadii;
            float4 _MainLightShadowParams;
            Texture2D<float> _MainLightShadowmapTexture;
            float4x4 _AdditionalLightsWorldToShadow[MAX_LIGHTS];
            float4 _AdditionalShadowParams[MAX_LIGHTS];
            float4 _AdditionalShadowFadeParams;
            Texture2D<float> _AdditionalLightsShadowmapTexture;
            float4 _FPParams0;
            float4 _FPParams1;
            float4 _FPParams2;

            cbuffer urp_ZBinBuffer
            {
                float4 urp_ZBins[1024];
            };

            cbuffer urp_TileBuffer
            {
                float4 urp_Tiles[4096];
            };

            struct Surface
            {
                float3 diffuse;
                float3 specular;
                float3 normal;
                float3 view;
                float roughness; // squared perceptual roughness
            };

            float3 Reflected(Surface s, float3 light)
            {
                float3 h = normalize(light + s.view);
                float nh = saturate(dot(s.normal, h));
                float lh = saturate(dot(light, h));
                float r2 = s.roughness * s.roughness;
                float d = nh * nh * (r2 - 1.0) + 1.00001;
                float term = r2 / (d * d * max(0.1, lh * lh) * (s.roughness * 4.0 + 2.0));
                return (s.diffuse + s.specular * term) * saturate(dot(s.normal, light));
            }

            float Lit(Texture2D<float> map, float3 place)
            {
                float2 size;
                map.GetDimensions(size.x, size.y);
                float sum = 0.0;
                [unroll]
                for (int y = -1; y <= 1; y++)
                {
                    [unroll]
                    for (int x = -1; x <= 1; x++)
                        sum += map.SampleCmpLevelZero(sampler_LinearClampCompare, place.xy + float2(x, y) / size, place.z);
                }
                float hard = map.SampleCmpLevelZero(sampler_LinearClampCompare, place.xy, place.z);
            #if defined(_SHADOWS_SOFT)
                return sum / 9.0;
            #else
                return hard;
            #endif
            }

            float Fade(float3 world, float2 scaleBias)
            {
                float3 away = world - _WorldSpaceCameraPos;
                float fade = saturate(dot(away, away) * scaleBias.x + scaleBias.y);
                return fade * fade;
            }

            float MainLightVisible(float3 world)
            {
            #if (defined(_MAIN_LIGHT_SHADOWS) || defined(_MAIN_LIGHT_SHADOWS_CASCADE)) && !defined(_RECEIVE_SHADOWS_OFF)
                int cascade = 0;
            #if defined(_MAIN_LIGHT_SHADOWS_CASCADE)
                float3 a = world - _CascadeShadowSplitSpheres0.xyz;
                float3 b = world - _CascadeShadowSplitSpheres1.xyz;
                float3 c = world - _CascadeShadowSplitSpheres2.xyz;
                float3 e = world - _CascadeShadowSplitSpheres3.xyz;
                bool4 inside = float4(dot(a, a), dot(b, b), dot(c, c), dot(e, e)) < _CascadeShadowSplitSphereRadii;
                cascade = inside.x ? 0 : inside.y ? 1 : inside.z ? 2 : inside.w ? 3 : 4;
            #endif
                float3 place = mul(_MainLightWorldToShadow[cascade], float4(world, 1.0)).xyz;
                float visible = place.z <= 0.0 || place.z >= 1.0 ? 1.0 : lerp(1.0, Lit(_MainLightShadowmapTexture, place), _MainLightShadowParams.x);
                return lerp(visible, 1.0, Fade(world, _MainLightShadowParams.zw));
            #else
                return 1.0;
            #endif
            }

            int CubeFace(float3 direction)
            {
                float3 size = abs(direction);
                if (size.x >= size.y && size.x >= size.z)
                    return direction.x > 0.0 ? 0 : 1;
                if (size.y >= size.z)
                    return direction.y > 0.0 ? 2 : 3;
                return direction.z > 0.0 ? 4 : 5;
            }

            float AdditionalLightVisible(int index, float3 world, float3 toLight)
            {
            #if defined(_ADDITIONAL_LIGHT_SHADOWS) && !defined(_RECEIVE_SHADOWS_OFF)
                float4 params = _AdditionalShadowParams[index];
                if (params.w < 0.0)
                    return 1.0;
                int slice = (int)params.w + (params.z > 0.5 ? CubeFace(-toLight) : 0);
                float4 place = mul(_AdditionalLightsWorldToShadow[slice], float4(world, 1.0));
                place.xyz /= place.w;
                float visible = place.z <= 0.0 || place.z >= 1.0 ? 1.0 : lerp(1.0, Lit(_AdditionalLightsShadowmapTexture, place.xyz), params.x);
                return lerp(visible, 1.0, Fade(world, _AdditionalShadowFadeParams.xy));
            #else
                return 1.0;
            #endif
            }

            float3 AdditionalLight(int index, Surface s, float3 world)
            {
                float4 position = _AdditionalLightsPosition[index];
                float4 attenuation = _AdditionalLightsAttenuation[index];
                float3 away = position.xyz - world * position.w;
                float squared = max(dot(away, away), 6.103515625e-5);
                float3 light = away * rsqrt(squared);
                float factor = squared * attenuation.x;
                float smooth = saturate(1.0 - factor * factor);
                float reach = position.w > 0.5 ? smooth * smooth / squared : 1.0;
                float angle = saturate(dot(_AdditionalLightsSpotDir[index].xyz, light) * attenuation.z + attenuation.w);
                float visible = reach * angle * angle * AdditionalLightVisible(index, world, light);
                return Reflected(s, light) * _AdditionalLightsColor[index].rgb * visible;
            }

            float3 AdditionalLights(Surface s, float3 world, float2 pixel)
            {
                float3 sum = 0.0;
            #if defined(_FORWARD_PLUS)
                for (int i = 0; i < (int)_FPParams0.w; i++)
                    sum += AdditionalLight(i, s, world);
                int words = (int)_FPParams1.w;
                float2 uv = pixel / _ScaledScreenParams.xy;
                uv.y = 1.0 - (uv.y * _ScaleBiasRt.x + _ScaleBiasRt.y);
                uint2 tile = (uint2)(uv * _FPParams1.xy);
                uint tileAt = (tile.y * (uint)_FPParams1.z + tile.x) * words;
                float depth = dot(-unity_MatrixV[2].xyz, world - _WorldSpaceCameraPos);
                float along = unity_OrthoParams.w > 0.5 ? depth : log2(max(depth, 1e-6));
                uint bin = min((uint)max(along * _FPParams0.x + _FPParams0.y, 0.0), (uint)_FPParams2.x - 1) * (2 + words);
                for (int word = 0; word < words; word++)
                {
                    uint t = tileAt + word;
                    uint z = bin + 2 + word;
                    uint mask = asuint(urp_Tiles[t / 4][t % 4]) & asuint(urp_ZBins[z / 4][z % 4]);
                    while (mask != 0)
                    {
                        uint bit = firstbitlow(mask);
                        mask &= mask - 1;
                        uint index = 32 * word + bit;
                        if (index < (uint)_FPParams0.z)
                            sum += AdditionalLight((int)_FPParams0.w + index, s, world);
                    }
                }
            #elif defined(_ADDITIONAL_LIGHTS)
                int count = (int)min(_AdditionalLightsCount.x, unity_LightData.y);
                for (int i = 0; i < count; i++)
                    sum += AdditionalLight((int)unity_LightIndices[i / 4][i % 4], s, world);
            #endif
                return sum;
            }

            float3 Ambient(float3 n)
            {
                float4 a = float4(n, 1.0);
                float4 b = n.xyzz * n.yzzx;
                float3 colour = float3(dot(unity_SHAr, a), dot(unity_SHAg, a), dot(unity_SHAb, a));
                colour += float3(dot(unity_SHBr, b), dot(unity_SHBg, b), dot(unity_SHBb, b)) + unity_SHC.rgb * (n.x * n.x - n.y * n.y);
                return max(colour, 0.0);
            }

            float3 Mirrored(float3 direction, float perceptual)
            {
                float level = perceptual * (1.7 - 0.7 * perceptual) * 6.0;
                float4 encoded = unity_SpecCube0.SampleLevel(sampler_LinearClamp, direction, level);
                float alpha = max(unity_SpecCube0_HDR.w * (encoded.a - 1.0) + 1.0, 0.0);
                return encoded.rgb * (unity_SpecCube0_HDR.x * pow(alpha, unity_SpecCube0_HDR.y));
            }

            float4 Shade(Varyings input) : SV_Target
            {
                float4 albedo = Albedo(input.uv);
                float perceptual = 1.0 - _Smoothness;
                Surface s;
                s.roughness = max(perceptual * perceptual, 0.0078125);
                s.normal = Normal(input);
                s.view = normalize(_WorldSpaceCameraPos - input.world);
                float reflectivity = lerp(0.04, 1.0, _Metallic);
                s.diffuse = albedo.rgb * (1.0 - reflectivity);
                s.specular = lerp((float3)0.04, albedo.rgb, _Metallic);
                float occlusion = lerp(1.0, _OcclusionMap.Sample(sampler_OcclusionMap, input.uv).g, _OcclusionStrength);

                float fresnel = pow(1.0 - saturate(dot(s.normal, s.view)), 4.0);
                float grazing = saturate(_Smoothness + reflectivity);
                float3 around = Mirrored(reflect(-s.view, s.normal), perceptual) / (s.roughness * s.roughness + 1.0);
                float3 colour = (Ambient(s.normal) * s.diffuse + around * lerp(s.specular, grazing, fresnel)) * occlusion;
                colour += Reflected(s, _MainLightPosition.xyz) * _MainLightColor.rgb * MainLightVisible(input.world) * unity_LightData.z;
                colour += AdditionalLights(s, input.world, input.clip.xy);
            #if defined(_EMISSION)
                colour += _EmissionMap.Sample(sampler_EmissionMap, input.uv).rgb * _EmissionColor.rgb;
            #endif
                return float4(colour, albedo.a);
            }
            ENDHLSL
        }

        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            ColorMask 0
            Cull [_Cull]

            HLSLPROGRAM
            #pragma vertex PlaceCaster
            #pragma fragment Cast
            #pragma multi_compile_vertex _ _CASTING_PUNCTUAL_LIGHT_SHADOW
            #pragma shader_feature_local _ALPHATEST_ON

            Varyings PlaceCaster(Attributes input)
            {
                Varyings output = Place(input);
            #if defined(_CASTING_PUNCTUAL_LIGHT_SHADOW)
                float3 light = normalize(_LightPosition - output.world);
            #else
                float3 light = _LightDirection;
            #endif
                float slope = 1.0 - saturate(dot(light, output.normal));
                float3 moved = output.world + light * _ShadowBias.x + output.normal * (slope * _ShadowBias.y);
                output.clip = mul(unity_MatrixVP, float4(moved, 1.0));
                output.clip.z = min(output.clip.z, output.clip.w);
                return output;
            }

            float4 Cast(Varyings input) : SV_Target
            {
                Albedo(input.uv);
                return 0.0;
            }
            ENDHLSL
        }

        Pass
        {
            Name "DepthOnly"
            Tags { "LightMode" = "DepthOnly" }
            ColorMask R
            Cull [_Cull]

            HLSLPROGRAM
            #pragma vertex Place
            #pragma fragment Depth
            #pragma shader_feature_local _ALPHATEST_ON

            float4 Depth(Varyings input) : SV_Target
            {
                Albedo(input.uv);
                return input.clip.z;
            }
            ENDHLSL
        }

        Pass
        {
            Name "DepthNormals"
            Tags { "LightMode" = "DepthNormals" }
            Cull [_Cull]

            HLSLPROGRAM
            #pragma vertex Place
            #pragma fragment Normals
            #pragma shader_feature_local _NORMALMAP
            #pragma shader_feature_local _ALPHATEST_ON

            float4 Normals(Varyings input) : SV_Target
            {
                Albedo(input.uv);
                return float4(Normal(input), 0.0);
            }
            ENDHLSL
        }
    }
}
