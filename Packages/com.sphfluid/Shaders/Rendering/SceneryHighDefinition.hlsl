// Scenery in the High Definition Render Pipeline: a light of its own from above and the left, not exposed, so that the picture is neither
// black nor white whatever the project's exposure is.
#ifndef SPHFLUID_SCENERY_HIGH_DEFINITION_INCLUDED
#define SPHFLUID_SCENERY_HIGH_DEFINITION_INCLUDED

#define FLUID_HDRP 1
#include "FluidShading.hlsl"
#include "SceneryTiles.hlsl"

float4x4 unity_ObjectToWorld;
float4x4 unity_WorldToObject;

#define OWN_LIGHT float3(-0.36, 0.8, -0.48) // a unit vector
#define SHADOWED 0.35

struct SceneryVertex
{
    float3 position : POSITION;
    float3 normal : NORMAL;
};

struct SceneryFragment
{
    float4 clipPosition : SV_Position;
    float3 normal : TEXCOORD0;
    float3 world : TEXCOORD1;
};

SceneryFragment PlaceScenery(SceneryVertex input)
{
    SceneryFragment output;
    float3 world = mul(unity_ObjectToWorld, float4(input.position, 1.0)).xyz;
    output.clipPosition = FluidClipPosition(world);
    output.world = world;
    output.normal = normalize(mul(input.normal, (float3x3)unity_WorldToObject));
    return output;
}

// Half Lambert: from full light to SHADOWED behind.
float4 ShadeScenery(SceneryFragment input) : SV_Target
{
    float3 normal = normalize(input.normal);
    float lit = 0.5 + 0.5 * dot(normal, OWN_LIGHT);
    float3 colour = SceneryColour(input.world, normal) * lerp(SHADOWED, 1.0, lit);
    return float4(lerp(colour, _FadeColor.rgb, SceneryFade(input.world, _WorldSpaceCameraPos)), 1.0);
}

float4 ShowNothing() : SV_Target
{
    return 0.0;
}

#endif
