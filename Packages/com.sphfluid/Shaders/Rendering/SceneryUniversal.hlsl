// Scenery in the Universal Render Pipeline 14 and newer. No include of the pipeline: the variables that it sets are declared here by the
// names of its Input.hlsl and Shadows.hlsl.
#ifndef SPHFLUID_SCENERY_UNIVERSAL_INCLUDED
#define SPHFLUID_SCENERY_UNIVERSAL_INCLUDED

#include "FluidShading.hlsl"

float4x4 unity_ObjectToWorld;
float4x4 unity_WorldToObject;
float4 unity_SHAr;
float4 unity_SHAg;
float4 unity_SHAb;
float4 unity_SHBr;
float4 unity_SHBg;
float4 unity_SHBb;
float4 unity_SHC;

#include "SceneryShading.hlsl"

float4 _MainLightPosition; // xyz: unit vector to the light
float4 _MainLightColor;
float4x4 _MainLightWorldToShadow[5]; // of four cascades, and one for what lies beyond them
float4 _CascadeShadowSplitSpheres0;
float4 _CascadeShadowSplitSpheres1;
float4 _CascadeShadowSplitSpheres2;
float4 _CascadeShadowSplitSpheres3;
float4 _CascadeShadowSplitSphereRadii; // squared
float4 _MainLightShadowParams;         // x: strength; z, w: how it fades with the squared distance from the camera
float4 _MainLightShadowmapSize;        // xy: a texel
float4 _ScaledScreenParams;            // xy: pixels of the picture
float4 _ShadowBias;                    // while shadows are cast; x: along the light, y: along the normal
float3 _LightDirection;
float3 _LightPosition;
Texture2D<float> _MainLightShadowmapTexture;
Texture2D<float> _ScreenSpaceShadowmapTexture;
SamplerComparisonState sampler_LinearClampCompare;
SamplerState sampler_PointClamp;

struct SceneryVertex
{
    float3 position : POSITION;
    float3 normal : NORMAL;
};

struct SceneryFragment
{
    float4 clipPosition : SV_Position;
    float3 world : TEXCOORD0;
    float3 normal : TEXCOORD1;
};

SceneryFragment PlaceScenery(SceneryVertex input)
{
    SceneryFragment output;
    output.world = mul(unity_ObjectToWorld, float4(input.position, 1.0)).xyz;
    output.normal = normalize(mul(input.normal, (float3x3)unity_WorldToObject));
    output.clipPosition = FluidClipPosition(output.world);
    return output;
}

// The first cascade whose sphere holds the point; 4 beyond all of them.
uint ShadowCascade(float3 world)
{
#if defined(_MAIN_LIGHT_SHADOWS_CASCADE)
    float3 offset0 = world - _CascadeShadowSplitSpheres0.xyz;
    float3 offset1 = world - _CascadeShadowSplitSpheres1.xyz;
    float3 offset2 = world - _CascadeShadowSplitSpheres2.xyz;
    float3 offset3 = world - _CascadeShadowSplitSpheres3.xyz;
    float4 distances = float4(dot(offset0, offset0), dot(offset1, offset1), dot(offset2, offset2), dot(offset3, offset3));
    bool4 inside = distances < _CascadeShadowSplitSphereRadii;
    return inside.x ? 0u : inside.y ? 1u : inside.z ? 2u : inside.w ? 3u : 4u;
#else
    return 0u;
#endif
}

// 1 in the light, 0 in its shadow.
float MainLightVisible(float3 world, float4 clipPosition)
{
#if defined(_MAIN_LIGHT_SHADOWS_SCREEN)
    return _ScreenSpaceShadowmapTexture.SampleLevel(sampler_PointClamp, clipPosition.xy / _ScaledScreenParams.xy, 0.0);
#elif defined(_MAIN_LIGHT_SHADOWS) || defined(_MAIN_LIGHT_SHADOWS_CASCADE)
    float3 place = mul(_MainLightWorldToShadow[ShadowCascade(world)], float4(world, 1.0)).xyz;
    float sum = 0.0;
    [unroll]
    for (int y = -1; y <= 1; y++)
    {
        [unroll]
        for (int x = -1; x <= 1; x++)
        {
            float2 texel = place.xy + float2(x, y) * _MainLightShadowmapSize.xy;
            sum += _MainLightShadowmapTexture.SampleCmpLevelZero(sampler_LinearClampCompare, texel, place.z);
        }
    }
    float3 away = world - _WorldSpaceCameraPos;
    float fade = saturate(dot(away, away) * _MainLightShadowParams.z + _MainLightShadowParams.w);
    float visible = lerp(1.0, sum / 9.0, _MainLightShadowParams.x * (1.0 - fade * fade));
    return place.z <= 0.0 || place.z >= 1.0 ? 1.0 : visible;
#else
    return 1.0;
#endif
}

float4 ShadeScenery(SceneryFragment input) : SV_Target
{
    float3 normal = normalize(input.normal);
    float3 view = normalize(_WorldSpaceCameraPos - input.world);
    float visible = MainLightVisible(input.world, input.clipPosition);
    float3 own = SceneryColour(input.world, normal);
    float3 colour = SceneryReflection(own, normal, view, _MainLightPosition.xyz) * _MainLightColor.rgb * visible;
    colour += SceneryAmbientReflection(own, normal, view);
    return float4(lerp(colour, _FadeColor.rgb, SceneryFade(input.world, _WorldSpaceCameraPos)), 1.0);
}

float4 PlaceSceneryShadow(SceneryVertex input) : SV_Position
{
    float3 world = mul(unity_ObjectToWorld, float4(input.position, 1.0)).xyz;
    float3 normal = normalize(mul(input.normal, (float3x3)unity_WorldToObject));
#if defined(_CASTING_PUNCTUAL_LIGHT_SHADOW)
    float3 light = normalize(_LightPosition - world);
#else
    float3 light = _LightDirection;
#endif
    world += light * _ShadowBias.x + normal * ((1.0 - saturate(dot(light, normal))) * _ShadowBias.y);
    float4 clipPosition = FluidClipPosition(world);
#if defined(FLUID_REVERSED_Z)
    clipPosition.z = min(clipPosition.z, clipPosition.w);
#else
    clipPosition.z = max(clipPosition.z, -clipPosition.w);
#endif
    return clipPosition;
}

float4 ShowNothing() : SV_Target
{
    return 0.0;
}

float4 ShowSceneryDepth(SceneryFragment input) : SV_Target
{
    return input.clipPosition.z;
}

float4 ShowSceneryNormal(SceneryFragment input) : SV_Target
{
    return float4(normalize(input.normal), 0.0);
}

#endif
