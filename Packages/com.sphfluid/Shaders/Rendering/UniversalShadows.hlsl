// The main light's shadow map of the Universal Render Pipeline 14 to 17: the variables of its ShaderLibrary/Shadows.hlsl, as
// Runtime/Passes/MainLightShadowCasterPass.cs sets them for each camera that has a map. Where no caster is in view the map is one lit texel
// and the strength the light's, or they are not set at all. No include of the pipeline.
#ifndef SPHFLUID_UNIVERSAL_SHADOWS_INCLUDED
#define SPHFLUID_UNIVERSAL_SHADOWS_INCLUDED

#define MAIN_LIGHT_CASCADES 4

float4x4 _MainLightWorldToShadow[MAIN_LIGHT_CASCADES + 1]; // behind the last cascade a matrix of no meaning
float4 _CascadeShadowSplitSpheres0;
float4 _CascadeShadowSplitSpheres1;
float4 _CascadeShadowSplitSpheres2;
float4 _CascadeShadowSplitSpheres3;
float4 _CascadeShadowSplitSphereRadii; // squared
float4 _MainLightShadowParams;         // x: strength; z, w: fade over the squared distance from the camera
Texture2D<float> _MainLightShadowmapTexture;
SamplerComparisonState sampler_LinearClampCompare;

// The first cascade whose sphere holds the point; MAIN_LIGHT_CASCADES beyond all of them.
int MainLightCascade(float3 world)
{
    float3 away0 = world - _CascadeShadowSplitSpheres0.xyz;
    float3 away1 = world - _CascadeShadowSplitSpheres1.xyz;
    float3 away2 = world - _CascadeShadowSplitSpheres2.xyz;
    float3 away3 = world - _CascadeShadowSplitSpheres3.xyz;
    float4 squared = float4(dot(away0, away0), dot(away1, away1), dot(away2, away2), dot(away3, away3));
    bool4 isInside = squared < _CascadeShadowSplitSphereRadii;
    return isInside.x ? 0 : isInside.y ? 1 : isInside.z ? 2 : isInside.w ? 3 : MAIN_LIGHT_CASCADES;
}

// Share of the light that reaches a place of a shadow map, 1 beyond its depths: three by three comparisons, a texel apart, as the pattern
// of water's partial shadow has a period of three (WaterShading.hlsl). URP tells a map's size only where soft shadows are on, so the map is
// asked itself.
float ShadowMapLight(Texture2D<float> map, float3 place)
{
    float2 size = 0.0;
    map.GetDimensions(size.x, size.y);
    float sum = 0.0;
    [unroll]
    for (int y = -1; y <= 1; y++)
    {
        [unroll]
        for (int x = -1; x <= 1; x++) sum += map.SampleCmpLevelZero(sampler_LinearClampCompare, place.xy + float2(x, y) / size, place.z);
    }
    return place.z <= 0.0 || place.z >= 1.0 ? 1.0 : sum / 9.0;
}

// 0 near the camera, 1 where the shadow has faded.
float MainLightShadowFade(float3 world)
{
    float3 away = world - _WorldSpaceCameraPos;
    return saturate(dot(away, away) * _MainLightShadowParams.z + _MainLightShadowParams.w);
}

#endif
