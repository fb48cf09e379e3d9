// The main light's shadow map of the Universal Render Pipeline 14 to 17: the variables of its ShaderLibrary/Shadows.hlsl, as
// Runtime/Passes/MainLightShadowCasterPass.cs sets them for each camera that has a map. No include of the pipeline.
#ifndef SPHFLUID_UNIVERSAL_SHADOWS_INCLUDED
#define SPHFLUID_UNIVERSAL_SHADOWS_INCLUDED

#define MAIN_LIGHT_CASCADES 4

float4x4 _MainLightWorldToShadow[MAIN_LIGHT_CASCADES + 1]; // behind the last cascade a matrix of no meaning
float4 _CascadeShadowSplitSpheres0;
float4 _CascadeShadowSplitSpheres1;
float4 _CascadeShadowSplitSpheres2;
float4 _CascadeShadowSplitSpheres3;
float4 _CascadeShadowSplitSphereRadii; // squared
float4 _MainLightShadowParams;         // x: strength, 0 where this camera has no map; z, w: fade over the squared distance from the camera
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

// 0 near the camera, 1 where the shadow has faded.
float MainLightShadowFade(float3 world)
{
    float3 away = world - _WorldSpaceCameraPos;
    return saturate(dot(away, away) * _MainLightShadowParams.z + _MainLightShadowParams.w);
}

#endif
