// Sky, sun and clouds by direction. What is seen depends on nothing but the direction, so that a reflection map of it agrees with the
// picture.
#ifndef SPHFLUID_SKY_INCLUDED
#define SPHFLUID_SKY_INCLUDED

#include "Eyes.hlsl"

float4x4 unity_ObjectToWorld;
float4 _WorldSpaceLightPos0; // xyz: to the sun, as Unity sets it for skyboxes; 0 without one

float4 _Zenith;
float4 _Horizon;
float4 _Ground;
float4 _Sun;
float _SunRadius; // degrees
float _SunLight;
float _Glow;
float4 _Cloud;
float4 _CloudShade;
float _CloudCover;
float _CloudScale;

#define HAZE_ABOVE 6.0  // doublings of clearness from the horizon up to the zenith
#define HAZE_BELOW 9.0
#define CLOUD_DOME 0.32 // keeps clouds near the horizon from being drawn out without end
#define CLOUD_EDGE 0.22 // of the noise, from clear sky to full cloud
#define NEARER_SUN 0.35 // how far off, in cells of the noise, a cloud is asked for its shade

struct SkyVertex
{
    float3 position : POSITION;
};

struct SkyFragment
{
    float4 clipPosition : SV_Position;
    float3 direction : TEXCOORD0;
    EYE_FIELD
};

SkyFragment PlaceSky(SkyVertex input EYE_PARAMETER)
{
    EYE_OF_INSTANCE
    SkyFragment output;
    EYE_TO(output)
    output.direction = mul((float3x3)unity_ObjectToWorld, input.position);
    output.clipPosition = mul(unity_MatrixVP, mul(unity_ObjectToWorld, float4(input.position, 1.0)));
    return output;
}

// A number from 0 to 1 for a cell of the plane, without sines, whose precision differs from device to device (Hoskins 2014).
float CellNoise(float2 cell)
{
    float3 mixed = frac(cell.xyx * 0.1031);
    mixed += dot(mixed, mixed.yzx + 33.33);
    return frac((mixed.x + mixed.y) * mixed.z);
}

float ValueNoise(float2 place)
{
    float2 cell = floor(place);
    float2 inside = place - cell;
    float2 weight = inside * inside * (3.0 - 2.0 * inside);
    float lower = lerp(CellNoise(cell), CellNoise(cell + float2(1.0, 0.0)), weight.x);
    float upper = lerp(CellNoise(cell + float2(0.0, 1.0)), CellNoise(cell + 1.0), weight.x);
    return lerp(lower, upper, weight.y);
}

// The next octave: turned by 37 degrees, so that the lattices do not show, and twice as fine.
float2 FinerCloud(float2 place)
{
    return float2(1.6 * place.x + 1.2 * place.y, 1.6 * place.y - 1.2 * place.x) + 17.3;
}

// Two octaves, 0 to 0.75: the bulk of clouds.
float CloudBulk(float2 place)
{
    return 0.5 * ValueNoise(place) + 0.25 * ValueNoise(FinerCloud(place));
}

// How much of the sky's light the clouds hide, and how far they are turned to the sun: 0 to 1 each.
float2 Clouds(float3 direction, float3 sun)
{
    float2 place = direction.xz * (2.6 * _CloudScale / (direction.y + CLOUD_DOME)) + 41.0;
    float bulk = CloudBulk(place);
    float2 finer = FinerCloud(FinerCloud(place));
    float whole = bulk + 0.125 * ValueNoise(finer) + 0.0625 * ValueNoise(FinerCloud(finer));
    // The noise lies about 0.51, near its middle the more often: even steps of the cover take smaller ones of the noise there.
    float beyond = 1.0 - 2.0 * _CloudCover;
    float clear = 0.5075 + 0.4325 * sign(beyond) * pow(abs(beyond), 1.5);
    float cover = smoothstep(clear, clear + CLOUD_EDGE, whole) * smoothstep(0.01, 0.12, direction.y);
    float shade = saturate(0.6 + 2.5 * (bulk - CloudBulk(place + NEARER_SUN * sun.xz)));
    return float2(cover, shade);
}

float4 ShadeSky(SkyFragment input) : SV_Target
{
    float3 direction = normalize(input.direction);
    float3 sun = _WorldSpaceLightPos0.xyz;
    float up = direction.y;
    if (up <= 0.0)
        return float4(lerp(_Ground.rgb, _Horizon.rgb, exp2(HAZE_BELOW * up)), 1.0);

    float facing = saturate(dot(direction, sun));
    float wide = facing * facing;
    wide *= wide;
    wide *= wide;
    float middle = wide * wide;
    middle *= middle;
    middle *= middle;
    float close = middle * middle;
    close *= close;
    close *= close;
    float glow = _Glow * (0.15 * wide + 0.35 * middle + 0.6 * close) * saturate(5.0 * up);

    float radius = radians(_SunRadius);
    float disc = _SunRadius > 0.0 ? smoothstep(cos(1.15 * radius), cos(0.85 * radius), facing) : 0.0;
    float3 colour = lerp(_Zenith.rgb, _Horizon.rgb, exp2(-HAZE_ABOVE * up)) + _Sun.rgb * (glow + _SunLight * disc);

    float2 clouds = Clouds(direction, sun);
    float3 cloud = lerp(_CloudShade.rgb, _Cloud.rgb, clouds.y) + _Sun.rgb * (0.5 * glow);
    return float4(lerp(colour, cloud, clouds.x), 1.0);
}

#endif
