// Per-pixel lighting of the liquid's surface (6.4.4.3): a coloured body under a mirror of the sky that grows towards grazing angles.
#ifndef SPHFLUID_SURFACE_SHADING_INCLUDED
#define SPHFLUID_SURFACE_SHADING_INCLUDED

#include "SurfaceGeometry.hlsl"

float4 _Color;
float _Smoothness;

#define EDGE_BRIGHTENING 0.5 // share of white in the body's colour where the liquid is seen edge on, that is thin

float4 ShadeSurface(SurfaceFragment input) : SV_Target
{
    float3 view = normalize(_WorldSpaceCameraPos - input.world);
    float3 normal = normalize(input.normal);
    float edgeOn = 1.0 - saturate(dot(normal, view));
    float3 body = lerp(_Color.rgb, 1.0, EDGE_BRIGHTENING * edgeOn * edgeOn);
    float mirrored = FluidFresnel(normal, view);
    float3 colour = FluidDiffuse(body, normal, input.world) * (1.0 - mirrored);
    colour += FluidAmbient(reflect(-view, normal)) * mirrored;
    colour += FluidHighlight(_Smoothness, normal, view, input.world);
    return float4(colour, 1.0);
}

#endif
