// Per-pixel lighting of the liquid's surface (6.4.4.3): a coloured body under a mirror of the sky that grows towards
// grazing angles.
#ifndef SPHFLUID_SURFACE_SHADING_INCLUDED
#define SPHFLUID_SURFACE_SHADING_INCLUDED

#include "SurfaceFragment.hlsl"
#include "../Rendering/ReceivedShadow.hlsl"

float4 _Color;
float _Smoothness;

#define EDGE_BRIGHTENING 0.7 // share of the colour's square root, a paler tint of it, where the liquid is seen edge on, that is thin

float4 ShadeSurface(SurfaceFragment input) : SV_Target
{
    EYE_OF(input)
    const float3 world = SurfaceWorld(input);
    float3 view = normalize(_WorldSpaceCameraPos - world);
    float3 normal = SurfaceNormal(input);
    float edgeOn = 1.0 - saturate(dot(normal, view));
    float3 body = lerp(_Color.rgb, sqrt(max(_Color.rgb, 0.0)), EDGE_BRIGHTENING * edgeOn * edgeOn);
    float mirrored = FluidFresnel(normal, view);
    float sun = ReceivedSun(world, normal);
    float3 colour = FluidDiffuse(body, normal, sun) * (1.0 - mirrored);
    colour += FluidAmbient(reflect(-view, normal)) * mirrored;
    colour += FluidHighlight(_Smoothness, normal, view) * sun;
    return float4(FluidExposed(colour), 1.0);
}

float4 CastSurfaceShadow(SurfaceFragment input) : SV_Target
{
    return 0.0;
}

float4 ShowSurfaceDepth(SurfaceFragment input) : SV_Target
{
    return input.clipPosition.z;
}

float4 ShowSurfaceNormal(SurfaceFragment input) : SV_Target
{
    return float4(SurfaceNormal(input), 0.0);
}

#endif
