// How much of the main light reaches a point, all of it in HDRP. No pipeline hands its shadows to transparent things, so the liquid reads
// the shadow map itself. Built-in: the map that MainLightShadows.cs keeps, placed by what ShadowConstants.hlsl copied. URP: its own map.
#ifndef SPHFLUID_RECEIVED_SHADOW_INCLUDED
#define SPHFLUID_RECEIVED_SHADOW_INCLUDED

#include "FluidShading.hlsl"
#include "UniversalShadows.hlsl"

// x: 1 if the drawing receives shadows; y: particle spacing [m]; z: strength of the shadow of the water around it
float4 _FluidReceived;
float4 _FluidShadowSource; // x: where shadows come from, SHADOW_*

Texture2D<float> _FluidShadowMap;
Texture2D<float4> _FluidShadowConstants; // 24 pixels: rows of the four matrices, split spheres (w: radius squared), splits, strength, fade

#define SHADOW_NONE 0.0 // MainLightShadows.cs
#define SHADOW_WHOLE 1.0
#define SHADOW_BY_DEPTH 2.0
#define SHADOW_BY_SPHERES 3.0
#define SHADOW_UNIVERSAL 4.0

// A point is tested beside its surface, or the surface would shade itself where the map steps: as far along the normal as three texels
// across rise over a slope, which is what the filter reaches, and a quarter of the spacing towards the light, for the bumps that particles
// leave.
#define FILTER_REACH 3.0
#define SURFACE_LIFT 0.25

struct ShadowCascade
{
    float4 rows[3];
    bool isThere;
};

ShadowCascade BuiltInCascade(float3 world, float eyeDepth)
{
    int cascade = 0;
    bool isThere = true;
    if (_FluidShadowSource.x != SHADOW_WHOLE)
    {
        isThere = false;
        float4 from = _FluidShadowConstants.Load(int3(20, 0, 0));
        float4 to = _FluidShadowConstants.Load(int3(21, 0, 0));
        [unroll]
        for (int i = 3; i >= 0; i--)
        {
            float4 sphere = _FluidShadowConstants.Load(int3(16 + i, 0, 0));
            float3 away = world - sphere.xyz;
            bool isInside = _FluidShadowSource.x == SHADOW_BY_SPHERES ? dot(away, away) < sphere.w
                : eyeDepth >= from[i] && eyeDepth < to[i];
            cascade = isInside ? i : cascade;
            isThere = isThere || isInside;
        }
    }
    ShadowCascade found;
    found.rows[0] = _FluidShadowConstants.Load(int3(4 * cascade, 0, 0));
    found.rows[1] = _FluidShadowConstants.Load(int3(4 * cascade + 1, 0, 0));
    found.rows[2] = _FluidShadowConstants.Load(int3(4 * cascade + 2, 0, 0));
    found.isThere = isThere;
    return found;
}

// Without cascades the second matrix is the one of no meaning, all zeros but for depth.
ShadowCascade UniversalCascade(float3 world)
{
    int cascade = 0;
    bool isThere = true;
    if (any(_MainLightWorldToShadow[1][0].xyz != 0.0))
    {
        cascade = MainLightCascade(world);
        isThere = cascade < MAIN_LIGHT_CASCADES;
    }
    ShadowCascade found;
    found.rows[0] = _MainLightWorldToShadow[cascade][0];
    found.rows[1] = _MainLightWorldToShadow[cascade][1];
    found.rows[2] = _MainLightWorldToShadow[cascade][2];
    found.isThere = isThere;
    return found;
}

float2 ShadowMapSize()
{
    float2 size = 0.0;
    if (_FluidShadowSource.x == SHADOW_UNIVERSAL)
        _MainLightShadowmapTexture.GetDimensions(size.x, size.y);
    else
        _FluidShadowMap.GetDimensions(size.x, size.y);
    return size;
}

// Of the four texels that meet at a corner those in the light: upper left, upper right, lower right, lower left, v being upwards.
float4 LitTexels(float2 corner, float depth)
{
    float4 lit = 0.0;
    if (_FluidShadowSource.x == SHADOW_UNIVERSAL)
        lit = _MainLightShadowmapTexture.GatherCmpRed(sampler_LinearClampCompare, corner, depth);
    else
        lit = _FluidShadowMap.GatherCmpRed(sampler_LinearClampCompare, corner, depth);
    return lit;
}

// The mean of three by three bilinear comparisons, a texel apart, of four by four texels: the pattern of water's partial shadow has a
// period of three (WaterShading.hlsl), and comes out even.
float LitShare(float3 place, float2 size)
{
    float2 first = floor(place.xy * size - 0.5);
    float2 within = place.xy * size - 0.5 - first;
    float4 lowerLeft = LitTexels(first / size, place.z);
    float4 lowerRight = LitTexels((first + float2(2.0, 0.0)) / size, place.z);
    float4 upperLeft = LitTexels((first + float2(0.0, 2.0)) / size, place.z);
    float4 upperRight = LitTexels((first + 2.0) / size, place.z);
    float4 columns = float4(1.0 - within.x, 1.0, 1.0, within.x);
    float lowest = dot(columns, float4(lowerLeft.wz, lowerRight.wz));
    float low = dot(columns, float4(lowerLeft.xy, lowerRight.xy));
    float high = dot(columns, float4(upperLeft.wz, upperRight.wz));
    float highest = dot(columns, float4(upperLeft.xy, upperRight.xy));
    return (lowest * (1.0 - within.y) + low + high + highest * within.y) / 9.0;
}

// x: light that a full shadow takes away; y: how far it has faded.
float2 ShadowStrength(float3 world, float eyeDepth)
{
    float2 shadow = float2(_MainLightShadowParams.x, MainLightShadowFade(world));
    if (_FluidShadowSource.x != SHADOW_UNIVERSAL)
    {
        float4 data = _FluidShadowConstants.Load(int3(22, 0, 0));
        float4 fade = _FluidShadowConstants.Load(int3(23, 0, 0));
        float metres = lerp(eyeDepth, distance(world, fade.xyz), fade.w);
        shadow = float2(1.0 - data.x, saturate(metres * data.z + data.w));
    }
    return shadow;
}

// Of nine texels of the map, those that the partial shadow of water fills (WaterShading.hlsl).
float FilledTexels(float strength)
{
    return floor(9.0 * strength + 0.5);
}

// 1 in the light, less in its shadow, and 1 where there is none.
// normal: of the surface, or zero; lift: towards the light, in spacings; water: strength of the shadow of the water around, 0 to 1. What
// its pattern takes is given back, or water would darken itself; only a shadow as of a solid thing, strength 1, darkens what lies under it.
float ReceivedSun(float3 world, float3 normal, float lift, float water)
{
    float sun = 1.0;
#if !defined(FLUID_HDRP)
    [branch]
    if (_FluidReceived.x > 0.5 && _FluidShadowSource.x != SHADOW_NONE &&
        !(_FluidShadowSource.x == SHADOW_UNIVERSAL && _MainLightShadowParams.x <= 0.0))
    {
        float eyeDepth = -dot(unity_MatrixV[2], float4(world, 1.0));
        ShadowCascade cascade;
        if (_FluidShadowSource.x == SHADOW_UNIVERSAL)
            cascade = UniversalCascade(world);
        else
            cascade = BuiltInCascade(world, eyeDepth);
        float2 size = max(ShadowMapSize(), 1.0);
        float2 texel = 1.0 / size;
        float metres = max(texel.x / max(length(cascade.rows[0].xyz), 1e-9), texel.y / max(length(cascade.rows[1].xyz), 1e-9));
        float along = dot(normal, _FluidLightDirection.xyz);
        float across = sqrt(saturate(dot(normal, normal) - along * along));
        float3 tested = world + normal * (FILTER_REACH * metres * across) + _FluidLightDirection.xyz * (lift * _FluidReceived.y);
        float4 point4 = float4(tested, 1.0);
        float3 place = float3(dot(cascade.rows[0], point4), dot(cascade.rows[1], point4), dot(cascade.rows[2], point4));
        bool isOnMap = cascade.isThere && all(place.xy == saturate(place.xy));
        float lit = isOnMap ? LitShare(saturate(place), size) : 1.0; // what lies behind the map's far plane has all casters before it
        float open = 9.0 - FilledTexels(water);
        lit = open > 0.5 ? saturate(lit * 9.0 / open) : lit;
        float2 strength = ShadowStrength(world, eyeDepth);
        sun = lerp(1.0 - strength.x * (1.0 - lit), 1.0, strength.y);
    }
#endif
    return sun;
}

// On an opaque surface.
float ReceivedSun(float3 world, float3 normal)
{
    return ReceivedSun(world, normal, SURFACE_LIFT, 0.0);
}

#endif
