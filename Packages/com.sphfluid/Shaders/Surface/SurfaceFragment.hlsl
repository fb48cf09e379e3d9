// A point of the liquid's surface as the pixel shader gets it, and its normal there.
#ifndef SPHFLUID_SURFACE_FRAGMENT_INCLUDED
#define SPHFLUID_SURFACE_FRAGMENT_INCLUDED

#include "SurfaceGrid.hlsl"
#include "SurfaceVertex.hlsl"
#include "../Rendering/FluidShading.hlsl"

struct SurfaceFragment
{
    float4 clipPosition : SV_Position;
    float3 local : TEXCOORD0; // m, simulation space: exact however far that is from the origin
    float3 normal : TEXCOORD1;
    EYE_FIELD
};

SurfaceFragment ProjectSurfaceVertex(SurfaceVertex surface)
{
    SurfaceFragment fragment;
    EYE_TO(fragment)
    fragment.local = surface.position;
    fragment.normal = FluidWorldDirection(surface.normal);
    fragment.clipPosition = FluidClipOfLocal(surface.position, (float3)0.0);
#if defined(FLUID_SHADOW_CASTER)
    fragment.clipPosition = FluidShadowClipPosition(fragment.clipPosition);
#endif
    return fragment;
}

float3 SurfaceWorld(SurfaceFragment input)
{
    return FluidWorldPosition(input.local);
}

// Vertices at the water's edge belong to the open surface and to the face at the wall; on that face, which lies in the
// ring, the wall decides.
float3 SurfaceNormal(SurfaceFragment input)
{
    float3 fromLower = (input.local - _MCMinimum) / _MCCellSize;
    float3 fromUpper = _MCCells - fromLower;
    float3 wall = (fromUpper < 1.5 * _MCRing ? (float3)1.0 : (float3)0.0) - (fromLower < 1.5 * _MCRing ? (float3)1.0 : (float3)0.0);
    return normalize(any(wall != 0.0) ? FluidWorldDirection(wall) : input.normal);
}

#endif
