#ifndef AUTOLIGHT_INCLUDED
#define AUTOLIGHT_INCLUDED

#include "UnityCG.cginc"

#ifdef SHADOWS_SCREEN

UNITY_DECLARE_SHADOWMAP(_ShadowMapTexture);

half UnitySampleShadow(float4 coord)
{
    half shadow = UNITY_SAMPLE_SHADOW(_ShadowMapTexture, coord.xyz);
    return lerp(_LightShadowData.r, 1.0h, shadow);
}

#define SHADOW_COORDS(index) float4 _ShadowCoord : TEXCOORD##index;
#define TRANSFER_SHADOW(o) o._ShadowCoord = mul(unity_WorldToShadow[0], mul(unity_ObjectToWorld, v.vertex));
#define SHADOW_ATTENUATION(i) UnitySampleShadow(i._ShadowCoord)

#else

#define SHADOW_COORDS(index)
#define TRANSFER_SHADOW(o)
#define SHADOW_ATTENUATION(i) 1.0

#endif

#define LIGHTING_COORDS(index0, index1) SHADOW_COORDS(index1)
#define UNITY_LIGHTING_COORDS(index0, index1) SHADOW_COORDS(index1)
#define UNITY_SHADOW_COORDS(index) SHADOW_COORDS(index)
#define TRANSFER_VERTEX_TO_FRAGMENT(o) TRANSFER_SHADOW(o)
#define UNITY_TRANSFER_LIGHTING(o, coord) TRANSFER_SHADOW(o)
#define UNITY_TRANSFER_SHADOW(o, coord) TRANSFER_SHADOW(o)
#define LIGHT_ATTENUATION(i) SHADOW_ATTENUATION(i)
#define UNITY_SHADOW_ATTENUATION(i, worldPosition) SHADOW_ATTENUATION(i)
#define UNITY_LIGHT_ATTENUATION(destination, i, worldPosition) half destination = SHADOW_ATTENUATION(i);

#endif
