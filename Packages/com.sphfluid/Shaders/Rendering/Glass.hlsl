// A thin pane: Schlick's approximation from the cover straight on to the cover edge on.
#ifndef SPHFLUID_GLASS_INCLUDED
#define SPHFLUID_GLASS_INCLUDED

#include "FluidShading.hlsl"

float4x4 unity_ObjectToWorld;
float4x4 unity_WorldToObject;
float4 _Color;
float _Edge;

struct PaneVertex
{
    float3 position : POSITION;
    float3 normal : NORMAL;
};

struct PaneFragment
{
    float4 clipPosition : SV_Position;
    float3 world : TEXCOORD0;
    float3 normal : TEXCOORD1;
    EYE_FIELD
};

PaneFragment PlacePane(PaneVertex input EYE_PARAMETER)
{
    EYE_OF_INSTANCE
    PaneFragment output;
    EYE_TO(output)
    output.world = mul(unity_ObjectToWorld, float4(input.position, 1.0)).xyz;
    output.clipPosition = FluidClipPosition(output.world);
    output.normal = mul(input.normal, (float3x3)unity_WorldToObject);
    return output;
}

float4 ShadePane(PaneFragment input) : SV_Target
{
    EYE_OF(input)
    float3 view = normalize(_WorldSpaceCameraPos - input.world);
    float grazing = 1.0 - saturate(abs(dot(normalize(input.normal), view)));
    float squared = grazing * grazing;
    float cover = lerp(_Color.a, max(_Edge, _Color.a), squared * squared * grazing);
    return float4(_Color.rgb * cover, cover);
}

#endif
