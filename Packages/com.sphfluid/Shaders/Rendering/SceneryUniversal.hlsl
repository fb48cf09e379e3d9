// Scenery in the Universal Render Pipeline 14 and newer. No include of the pipeline: the variables that it sets are declared here by the
// names of its Input.hlsl, those of its shadows in UniversalShadows.hlsl.
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

float4 unity_OrthoParams; // w: 1 for an orthographic camera
float4 _ProjectionParams; // x: -1 where the picture is drawn upside down

#include "SceneryShading.hlsl"
#include "UniversalShadows.hlsl"
#include "UniversalLights.hlsl"

float4 _MainLightPosition; // xyz: unit vector to the light
float4 _MainLightColor;
float4 _ScaledScreenParams; // xy: pixels of the picture
float4 _ShadowBias;         // while shadows are cast; x: along the light, y: along the normal
float3 _LightDirection;
float3 _LightPosition;
EYE_TEXTURE<float> _ScreenSpaceShadowmapTexture;
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
    EYE_FIELD
};

SceneryFragment PlaceScenery(SceneryVertex input EYE_PARAMETER)
{
    EYE_OF_INSTANCE
    SceneryFragment output;
    EYE_TO(output)
    output.world = mul(unity_ObjectToWorld, float4(input.position, 1.0)).xyz;
    output.normal = normalize(mul(input.normal, (float3x3)unity_WorldToObject));
    output.clipPosition = FluidClipPosition(output.world);
    return output;
}

// 1 in the light, 0 in its shadow.
float MainLightVisible(float3 world, float4 clipPosition)
{
#if defined(_MAIN_LIGHT_SHADOWS_SCREEN)
    return _ScreenSpaceShadowmapTexture.SampleLevel(sampler_PointClamp, EyePlace(clipPosition.xy / _ScaledScreenParams.xy), 0.0);
#elif defined(_MAIN_LIGHT_SHADOWS) || defined(_MAIN_LIGHT_SHADOWS_CASCADE)
#if defined(_MAIN_LIGHT_SHADOWS_CASCADE)
    int cascade = MainLightCascade(world);
#else
    int cascade = 0;
#endif
    float3 place = mul(_MainLightWorldToShadow[cascade], float4(world, 1.0)).xyz;
    float lit = ShadowMapLight(_MainLightShadowmapTexture, place);
    return lerp(1.0, lit, _MainLightShadowParams.x * (1.0 - MainLightShadowFade(world)));
#else
    return 1.0;
#endif
}

// Point, spot and further directional lights.
float3 SceneryLamps(float3 own, float3 normal, float3 view, float3 world)
{
    float3 colour = 0.0;
#if defined(UNIVERSAL_LIGHTS)
    float4 clipPosition = FluidClipPosition(world);
    float2 screen = clipPosition.xy / clipPosition.w * float2(0.5, 0.5 * _ProjectionParams.x) + 0.5;
    UniversalLightList list = StartLights(world, screen);
    uint index = 0u;
    [loop]
    while (NextLight(list, index))
    {
        UniversalLight light = AdditionalLight(index, world);
        colour += SceneryReflection(own, normal, view, light.direction) * light.colour;
    }
#endif
    return colour;
}

float4 ShadeScenery(SceneryFragment input) : SV_Target
{
    EYE_OF(input)
    float3 normal = normalize(input.normal);
    float3 view = normalize(_WorldSpaceCameraPos - input.world);
    float visible = MainLightReaches() * MainLightVisible(input.world, input.clipPosition);
    float3 own = SceneryColour(input.world, normal);
    float3 colour = SceneryReflection(own, normal, view, _MainLightPosition.xyz) * _MainLightColor.rgb * visible;
    colour += SceneryLamps(own, normal, view, input.world);
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
