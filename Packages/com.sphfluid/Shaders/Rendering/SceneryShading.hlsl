// How a body reflects light: Lambert's diffuse light and a highlight by GGX (Walter et al. 2007), Smith's visibility and
// Schlick's Fresnel term. The file that includes it declares or includes unity_SHAr ... unity_SHC, which every pipeline sets.
#ifndef SPHFLUID_SCENERY_SHADING_INCLUDED
#define SPHFLUID_SCENERY_SHADING_INCLUDED

#include "SceneryTiles.hlsl"

float _Smoothness;

#define SCENERY_REFLECTANCE 0.04 // of plastic, glass and wood, seen straight on

// The share of a light of colour 1 that goes to the viewer; pi is left out, as in Unity's light colours.
float3 SceneryReflection(float3 colour, float3 normal, float3 view, float3 light)
{
    float3 between = normalize(light + view);
    float lit = saturate(dot(normal, light));
    float facing = saturate(dot(normal, between));
    float seen = saturate(dot(normal, view)) + 1e-4;
    float roughness = max((1.0 - _Smoothness) * (1.0 - _Smoothness), 0.002);
    float squared = roughness * roughness;
    float spread = facing * facing * (squared - 1.0) + 1.0;
    float distribution = squared / (spread * spread + 1e-7);
    float visibility = 0.5 / (lit * (seen * (1.0 - roughness) + roughness) + seen * (lit * (1.0 - roughness) + roughness) + 1e-5);
    float grazing = 1.0 - saturate(dot(light, between));
    float fresnel = SCENERY_REFLECTANCE + (1.0 - SCENERY_REFLECTANCE) * grazing * grazing * grazing * grazing * grazing;
    return (colour * (1.0 - SCENERY_REFLECTANCE) + fresnel * visibility * distribution) * lit;
}

// What the body scatters of light that has its cosine already.
float3 SceneryDiffuse(float3 colour, float3 light)
{
    return colour * (1.0 - SCENERY_REFLECTANCE) * light;
}

// Ambient light from a direction: spherical harmonics of order 2 as Unity lays them out.
float3 SceneryAmbient(float3 direction)
{
    float4 n = float4(direction, 1.0);
    float4 products = n.xyzz * n.yzzx;
    float3 light = float3(dot(unity_SHAr, n), dot(unity_SHAg, n), dot(unity_SHAb, n));
    light += float3(dot(unity_SHBr, products), dot(unity_SHBg, products), dot(unity_SHBb, products));
    light += unity_SHC.xyz * (n.x * n.x - n.y * n.y);
    light = max(light, 0.0);
#if defined(UNITY_COLORSPACE_GAMMA)
    light = max(1.055 * pow(light, 1.0 / 2.4) - 0.055, 0.0);
#endif
    return light;
}

// What the body sends back of the ambient light; what it mirrors of it is blurred by its roughness.
float3 SceneryAmbientReflection(float3 colour, float3 normal, float3 view)
{
    float rough = 1.0 - _Smoothness;
    float grazing = 1.0 - saturate(dot(normal, view));
    float edge = SCENERY_REFLECTANCE
        + (max(_Smoothness, SCENERY_REFLECTANCE) - SCENERY_REFLECTANCE) * grazing * grazing * grazing * grazing * grazing;
    float3 mirrored = SceneryAmbient(normalize(lerp(normal, reflect(-view, normal), _Smoothness)));
    return colour * (1.0 - SCENERY_REFLECTANCE) * SceneryAmbient(normal) + mirrored * (edge / (1.0 + rough * rough));
}

#endif
