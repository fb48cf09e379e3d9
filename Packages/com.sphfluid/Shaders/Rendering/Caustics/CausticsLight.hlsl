// How much light arrives at a point in the water, to that in calm water: every texel of the map sends as much, so it is the density of what
// arrives around the point, by a quadratic B-spline three texels wide (Silverman 1986). Over calm water the splines add up to 1. On the
// whole no light is lost or gained: where waves gather it, it is missing beside.
#ifndef SPHFLUID_CAUSTICS_LIGHT_INCLUDED
#define SPHFLUID_CAUSTICS_LIGHT_INCLUDED

#include "CausticsTypes.hlsl"

Texture2D<float4> _CausticsMap;
float4 _FluidExtinction; // rgb: light lost per metre [1/m]
float4 _FluidScattering; // rgb: share of that which is scattered

#define COARSE_LEVEL 2.0 // of the map: waves that turn all light around a point aside
#define REACH 4          // texels that light is looked for around where it comes from on the whole
#define MOST_GAIN 4.0
#define FADE_SPACINGS 2.0 // beyond the domain, over which it ends

struct DomainFragment
{
    float4 clipPosition : SV_Position;
    float3 world : TEXCOORD0;
    EYE_FIELD
};

// The box of the domain and a little more: six faces of two triangles.
DomainFragment CoverDomain(uint id : SV_VertexID EYE_PARAMETER)
{
    EYE_OF_INSTANCE
    uint face = id / 6u;
    uint corner = id % 6u;
    float side = (float)(face & 1u);
    float u = corner == 1u || corner == 2u || corner == 4u ? 1.0 : 0.0;
    float v = corner == 2u || corner == 4u || corner == 5u ? 1.0 : 0.0;
    float2 across = side > 0.5 ? float2(u, v) : float2(v, u);
    float3 place = face < 2u ? float3(side, across) : face < 4u ? float3(across.y, side, across.x) : float3(across, side);
    float margin = FADE_SPACINGS * _FluidReceived.y;
    DomainFragment fragment;
    EYE_TO(fragment)
    fragment.world = FluidWorldPosition(_MCMinimum - margin + place * (_MCCells * _MCCellSize + 2.0 * margin));
    fragment.clipPosition = FluidClipPosition(fragment.world);
    fragment.clipPosition.z = 0.5 * fragment.clipPosition.w; // seen beyond the far plane too
    return fragment;
}

// What the camera sees on the line of sight through a point.
float3 ScenePoint(float3 world)
{
    float depth = SceneEyeDepth(WaterScreen(world));
    float own = WaterEyeDepth(world);
    return unity_OrthoParams.w > 0.5 ? world - normalize(unity_MatrixV[2].xyz) * (depth - own)
        : _WorldSpaceCameraPos + (world - _WorldSpaceCameraPos) * (depth / own);
}

// 1 in the domain, 0 a little beyond it.
float DomainShare(float3 world)
{
    float3 place = FluidLocalPosition(world) - _MCMinimum;
    float3 beyond = max(max(-place, place - _MCCells * _MCCellSize), 0.0);
    return saturate(1.0 - length(beyond) / (FADE_SPACINGS * max(_FluidReceived.y, 1e-6)));
}

float2 Spline(float2 away)
{
    float2 x = abs(away);
    float2 outer = max(1.5 - x, 0.0);
    return x < 0.5 ? 0.75 - x * x : 0.5 * outer * outer;
}

// How far light goes down from a texel of the map to a height, metres.
float WayDown(float4 texel, float height)
{
    return max(texel.z / max(texel.w, 1e-3) - height, 0.0);
}

// Where on the map the light of a place comes from. x, y: texels; z: metres of water above; w: share of the light that is bent.
float4 Origin(float2 place, float height)
{
    float4 origin = float4(place, 0.0, 1.0);
    [loop]
    for (uint i = 0u; i < 3u; i++)
    {
        float4 coarse = _CausticsMap.SampleLevel(sampler_LinearClamp, origin.xy / _CausticsStrength.y, COARSE_LEVEL);
        origin.z = WayDown(coarse, height);
        origin.w = min(coarse.w, origin.w);
        origin.xy = place - coarse.xy / max(coarse.w, 1e-3) * origin.z;
    }
    return origin;
}

float Gather(float2 place, float2 origin, float height)
{
    float2 first = floor(origin) - (float)REACH;
    float sum = 0.0;
    [loop]
    for (uint y = 0u; y <= 2u * REACH; y++)
    {
        [loop]
        for (uint x = 0u; x <= 2u * REACH; x++)
        {
            float2 middle = first + float2(x, y) + 0.5;
            float4 texel = _CausticsMap.Load(int3((int2)clamp(middle, 0.5, _CausticsStrength.y - 0.5), 0));
            float2 weights = Spline(middle + texel.xy * WayDown(texel, height) - place);
            sum += weights.x * weights.y;
        }
    }
    return sum;
}

// Share of the light at a point that is the main light's.
float3 MainLightShare(float3 world, float3 normal)
{
    float sun = ReceivedSun(world, normal, SURFACE_LIFT, _FluidReceived.z);
    float3 direct = FluidLampColour() * (saturate(dot(normal, _FluidLightDirection.xyz)) * sun);
    return direct / max(direct + FluidAmbient(normal), 1e-4);
}

float4 GatherLight(DomainFragment input) : SV_Target
{
    EYE_OF(input)
    float3 world = ScenePoint(input.world);
    float3 face = cross(ddy(world), ddx(world));
    float share = DomainShare(world);
    float height = world.y - FluidWorldPosition(0.0).y;
    float2 place = float2(dot(_CausticsRows[0], float4(world, 1.0)), dot(_CausticsRows[1], float4(world, 1.0)));
    float4 origin = Origin(place, height);
    float3 gain = 1.0;
    [branch]
    if (share > 0.0 && origin.z > 0.0)
    {
        float3 normal = dot(face, face) > 0.0 ? normalize(face) : float3(0.0, 1.0, 0.0);
        normal *= dot(normal, WaterView(world)) < 0.0 ? -1.0 : 1.0;
        float focus = min(Gather(place, origin.xy, height), MOST_GAIN) - 1.0;
        float3 left = exp(-_FluidExtinction.rgb * _FluidScattering.rgb * origin.z); // what is absorbed is missing everywhere alike
        gain += _CausticsStrength.x * share * saturate(4.0 * origin.w - 3.0) * focus * left * MainLightShare(world, normal);
    }
    return float4(0.5 * gain, 1.0);
}

#endif
