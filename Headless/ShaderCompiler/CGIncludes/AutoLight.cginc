#ifndef AUTOLIGHT_INCLUDED
#define AUTOLIGHT_INCLUDED

#include "UnityCG.cginc"

#ifdef SHADOWS_SCREEN

UNITY_DECLARE_SHADOWMAP(_ShadowMapTexture);

// Nine bilinear comparisons over 3 x 3 texels, in place of Unity's filter in screen space; each at the depth that the surface has there,
// and a texel nearer to the light.
half UnitySampleShadow(float4 coord)
{
    float width;
    float height;
    _ShadowMapTexture.GetDimensions(width, height);
    float2 texel = 1.0 / float2(width, height);
    float3 right = ddx(coord.xyz);
    float3 up = ddy(coord.xyz);
    float area = right.x * up.y - right.y * up.x;
    float2 slope = float2(right.z * up.y - right.y * up.z, right.x * up.z - right.z * up.x);
    slope = abs(area) > 1e-12 ? clamp(slope / area, -16.0, 16.0) : 0.0;
    float nearer = dot(abs(slope), texel);
    float sum = 0.0;
    [unroll]
    for (int y = -1; y <= 1; y++)
    {
        [unroll]
        for (int x = -1; x <= 1; x++)
        {
            float2 offset = float2(x, y) * texel;
            float depth = coord.z + dot(offset, slope) + nearer; // reversed: the light's side has the larger depth
            sum += UNITY_SAMPLE_SHADOW(_ShadowMapTexture, float3(coord.xy + offset, depth));
        }
    }
    bool outside = any(coord.xy < 0.0) || any(coord.xy > 1.0);
    return outside ? 1.0h : (half)lerp(_LightShadowData.r, 1.0, sum / 9.0);
}

#define SHADOW_COORDS(index) float4 _ShadowCoord : TEXCOORD##index;
#define TRANSFER_SHADOW(o) o._ShadowCoord = mul(unity_WorldToShadow[0], mul(unity_ObjectToWorld, v.vertex));
#define SHADOW_ATTENUATION(i) UnitySampleShadow(i._ShadowCoord)

#else

#define SHADOW_COORDS(index)
#define TRANSFER_SHADOW(o)
#define SHADOW_ATTENUATION(i) 1.0

#endif

// A light of a ForwardAdd pass: its matrix takes world space to light space, where the range is 1; the falloff is read at the square
// of the distance. DIRECTIONAL has none.
#if defined(POINT) || defined(SPOT) || defined(POINT_COOKIE) || defined(DIRECTIONAL_COOKIE)

float4x4 unity_WorldToLight;
#ifdef POINT_COOKIE
UNITY_DECLARE_TEXCUBE(_LightTexture0);
#else
UNITY_DECLARE_TEX2D(_LightTexture0);
#endif
#if defined(SPOT) || defined(POINT_COOKIE)
UNITY_DECLARE_TEX2D(_LightTextureB0);
#endif

float4 UnityLightCoord(float3 worldPosition)
{
    return mul(unity_WorldToLight, float4(worldPosition, 1.0));
}

half UnityLightReach(float4 coord)
{
    float squared = dot(coord.xyz, coord.xyz);
#if defined(SPOT)
    half cone = coord.z > 0.0 ? UNITY_SAMPLE_TEX2D(_LightTexture0, coord.xy / coord.w + 0.5).a : 0.0;
    return cone * UNITY_SAMPLE_TEX2D(_LightTextureB0, float2(squared, squared)).r;
#elif defined(POINT_COOKIE)
    return UNITY_SAMPLE_TEX2D(_LightTextureB0, float2(squared, squared)).r * UNITY_SAMPLE_TEXCUBE(_LightTexture0, coord.xyz).a;
#elif defined(DIRECTIONAL_COOKIE)
    return UNITY_SAMPLE_TEX2D(_LightTexture0, coord.xy).a;
#else
    return UNITY_SAMPLE_TEX2D(_LightTexture0, float2(squared, squared)).r;
#endif
}

#define DECLARE_LIGHT_COORDS(index) float4 _LightCoord : TEXCOORD##index;
#define COMPUTE_LIGHT_COORDS(o) o._LightCoord = UnityLightCoord(mul(unity_ObjectToWorld, v.vertex).xyz);
#define LIGHT_ATTENUATION(i) (UnityLightReach(i._LightCoord) * SHADOW_ATTENUATION(i))
#define UNITY_LIGHT_ATTENUATION(destination, i, worldPosition) \
    half destination = UnityLightReach(UnityLightCoord(worldPosition)) * SHADOW_ATTENUATION(i);

#else

#define DECLARE_LIGHT_COORDS(index)
#define COMPUTE_LIGHT_COORDS(o)
#define LIGHT_ATTENUATION(i) SHADOW_ATTENUATION(i)
#define UNITY_LIGHT_ATTENUATION(destination, i, worldPosition) half destination = SHADOW_ATTENUATION(i);

#endif

#define LIGHTING_COORDS(index0, index1) DECLARE_LIGHT_COORDS(index0) SHADOW_COORDS(index1)
#define UNITY_LIGHTING_COORDS(index0, index1) DECLARE_LIGHT_COORDS(index0) SHADOW_COORDS(index1)
#define UNITY_SHADOW_COORDS(index) SHADOW_COORDS(index)
#define TRANSFER_VERTEX_TO_FRAGMENT(o) COMPUTE_LIGHT_COORDS(o) TRANSFER_SHADOW(o)
#define UNITY_TRANSFER_LIGHTING(o, coord) COMPUTE_LIGHT_COORDS(o) TRANSFER_SHADOW(o)
#define UNITY_TRANSFER_SHADOW(o, coord) TRANSFER_SHADOW(o)
#define UNITY_SHADOW_ATTENUATION(i, worldPosition) SHADOW_ATTENUATION(i)

#endif
