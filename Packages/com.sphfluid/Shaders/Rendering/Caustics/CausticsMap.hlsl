// The surface that the main light meets first, as the light sees it: where it sends the light that enters there.
#ifndef SPHFLUID_CAUSTICS_MAP_INCLUDED
#define SPHFLUID_CAUSTICS_MAP_INCLUDED

#include "../SurfaceDrawing.hlsl"
#include "CausticsTypes.hlsl"

Texture2D<float4> _CausticsEnds;

#define THIN_LAYER 2.0 // spacings: light leaves drops and sheets as it came; from twice that on it is all bent
#define STEEP 0.2      // cosine to the vertical: walls of the water bend no light to the floor; from twice that on it is all bent

// Metres towards the light, from the middle of the domain.
float TowardsLight(float3 local)
{
    return dot(_FluidLightDirection.xyz, FluidWorldDirection(local));
}

// Far faces with the larger of two: the end of the layer that the light meets first.
float4 ShowEnd(SurfaceFragment input) : SV_Target
{
    return TowardsLight(input.local);
}

// xy: texels that light is turned aside for each metre that it goes down; z: height above the middle of the domain [m]; w: share of the
// light that is bent. All are times the share, so that they can be averaged. Worked example: light from above through calm water is not
// turned aside, so a texel is (0, 0, height, 1).
float4 ShowRefraction(SurfaceFragment input) : SV_Target
{
    float3 normal = SurfaceNormal(input);
    float layer = TowardsLight(input.local) - _CausticsEnds.Load(int3((int2)input.clipPosition.xy, 0)).x;
    float share = saturate(layer / (THIN_LAYER * max(_FluidReceived.y, 1e-6)) - 1.0) * saturate(normal.y / STEEP - 1.0);
    float3 bent = refract(-_FluidLightDirection.xyz, normal, AIR_TO_WATER);
    float2 aside = float2(dot(_CausticsRows[0].xyz, bent), dot(_CausticsRows[1].xyz, bent)) / max(-bent.y, STEEP);
    return float4(aside, FluidWorldDirection(input.local).y, 1.0) * share;
}

#endif
