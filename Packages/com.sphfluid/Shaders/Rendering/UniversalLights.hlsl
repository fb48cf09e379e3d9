// Lights beside the main one in the Universal Render Pipeline 14 to 17: the variables of its ShaderLibrary/Input.hlsl, as
// Runtime/ForwardLights.cs sets them. No include of the pipeline.
//
// Forward: an object has a list of up to eight lights. Forward+ and deferred+: directional lights come first, and the others are listed as
// bits, for each tile of the picture and for each of the bins that divide its depth. A bin begins with a word for the lights in it, the
// first in the lower half, the last in the upper one, then a word for reflection probes, then the bits.
#ifndef SPHFLUID_UNIVERSAL_LIGHTS_INCLUDED
#define SPHFLUID_UNIVERSAL_LIGHTS_INCLUDED

#include "UniversalShadows.hlsl"

#if defined(_CLUSTER_LIGHT_LOOP) || defined(_FORWARD_PLUS)
#define UNIVERSAL_CLUSTERS 1
#endif
#if defined(UNIVERSAL_CLUSTERS) || defined(_ADDITIONAL_LIGHTS) || defined(_ADDITIONAL_LIGHTS_VERTEX)
#define UNIVERSAL_LIGHTS 1
#endif

float4 unity_LightData; // x: unused; y: lights of the object; z: 0 where the main light does not reach its layer. Forward only

// 1, or 0 where the main light's culling mask leaves the object out.
float MainLightReaches()
{
#if defined(UNIVERSAL_CLUSTERS)
    return 1.0;
#else
    return unity_LightData.z;
#endif
}

#if defined(UNIVERSAL_LIGHTS)

// As many as the pipeline's package com.unity.render-pipelines.universal-config says by default.
#if defined(SHADER_API_MOBILE) && defined(SHADER_API_GLES30)
#define UNIVERSAL_MOST_LIGHTS 16
#elif defined(SHADER_API_MOBILE) || (defined(SHADER_API_GLCORE) && !defined(SHADER_API_SWITCH) && !defined(SHADER_API_SWITCH2)) || \
    defined(SHADER_API_GLES3) || defined(SHADER_API_WEBGPU)
#define UNIVERSAL_MOST_LIGHTS 32
#else
#define UNIVERSAL_MOST_LIGHTS 256
#endif

float4 _AdditionalLightsCount; // x: most that an object may have

cbuffer AdditionalLights
{
    float4 _AdditionalLightsPosition[UNIVERSAL_MOST_LIGHTS];    // w: 0 of a directional light, whose direction it is
    float4 _AdditionalLightsColor[UNIVERSAL_MOST_LIGHTS];
    float4 _AdditionalLightsAttenuation[UNIVERSAL_MOST_LIGHTS]; // x: 1 / range^2; z, w: from the cosine to a spot's axis to its light
    float4 _AdditionalLightsSpotDir[UNIVERSAL_MOST_LIGHTS];     // xyz: against the way of a spot's light
};

// What a light sends to a point.
struct UniversalLight
{
    float3 direction; // unit vector to it
    float3 colour;
};

#if defined(_ADDITIONAL_LIGHT_SHADOWS)

cbuffer AdditionalLightShadows
{
    float4 _AdditionalShadowParams[UNIVERSAL_MOST_LIGHTS];          // x: strength; z: 1 of a point light; w: its first slice, -1: none
    float4x4 _AdditionalLightsWorldToShadow[UNIVERSAL_MOST_LIGHTS]; // of slices: a spot light has one, a point light six
};

float4 _AdditionalShadowFadeParams; // x, y: fade over the squared distance from the camera
Texture2D<float> _AdditionalLightsShadowmapTexture;

// Slices of a point light: +x, -x, +y, -y, +z, -z.
int CubeFace(float3 direction)
{
    float3 size = abs(direction);
    float3 isBehind = float3(direction.x < 0.0 ? 1.0 : 0.0, direction.y < 0.0 ? 1.0 : 0.0, direction.z < 0.0 ? 1.0 : 0.0);
    float face = size.z >= max(size.x, size.y) ? 4.0 + isBehind.z : size.y >= size.x ? 2.0 + isBehind.y : isBehind.x;
    return (int)face;
}

// 1 in the light, 0 in its shadow.
float AdditionalLightVisible(uint index, float3 world, float3 direction)
{
    float4 shadow = _AdditionalShadowParams[index];
    float visible = 1.0;
    [branch]
    if (shadow.w >= 0.0 && shadow.x > 0.0)
    {
        int slice = (int)shadow.w + (shadow.z > 0.5 ? CubeFace(-direction) : 0);
        float4 place = mul(_AdditionalLightsWorldToShadow[slice], float4(world, 1.0));
        place.xyz /= place.w;
        float lit = ShadowMapLight(_AdditionalLightsShadowmapTexture, place.xyz);
        float3 away = world - _WorldSpaceCameraPos;
        float fade = saturate(dot(away, away) * _AdditionalShadowFadeParams.x + _AdditionalShadowFadeParams.y);
        visible = lerp(1.0, lit, shadow.x * (1.0 - fade));
    }
    return visible;
}

#else

float AdditionalLightVisible(uint index, float3 world, float3 direction)
{
    return 1.0;
}

#endif

// Inverse square of the distance, led to zero at the range; a spot's light falls off as the square between its inner and outer cone.
// Worked example, range 4 m: at 2 m 1 / 4 * (1 - (4 / 16)^2)^2 = 0.22.
UniversalLight AdditionalLight(uint index, float3 world)
{
    float4 position = _AdditionalLightsPosition[index];
    float4 reach = _AdditionalLightsAttenuation[index];
    float3 towards = position.xyz - world * position.w;
    float squared = max(dot(towards, towards), 6.1e-5);
    float part = squared * reach.x;
    float near = saturate(1.0 - part * part);

    UniversalLight light;
    light.direction = towards * rsqrt(squared);
    float cone = saturate(dot(_AdditionalLightsSpotDir[index].xyz, light.direction) * reach.z + reach.w);
    light.colour = _AdditionalLightsColor[index].rgb * (near * near * cone * cone / squared);
    [branch]
    if (dot(light.colour, 1.0) > 0.0)
        light.colour *= AdditionalLightVisible(index, world, light.direction);
    return light;
}

#if defined(UNIVERSAL_CLUSTERS)

float4 _FPParams0; // x, y: from depth, or its logarithm, to the number of a bin; w: directional lights
float4 _FPParams1; // x, y: tiles across the picture; z: tiles in a row; w: words of a tile
float4 _FPParams2; // x: bins; y: tiles

#if defined(_CLUSTER_LIGHT_LOOP) || UNITY_VERSION >= 202310
cbuffer urp_ZBinBuffer
{
    float4 urp_ZBins[1024];
};
#define UNIVERSAL_BINS urp_ZBins
#else
cbuffer URP_ZBinBuffer
{
    float4 URP_ZBins[1024];
};
#define UNIVERSAL_BINS URP_ZBins
#endif

cbuffer urp_TileBuffer
{
#if UNIVERSAL_MOST_LIGHTS <= 32
    float4 urp_Tiles[1024];
#else
    float4 urp_Tiles[4096];
#endif
};

uint BinWord(uint index)
{
    uint4 four = asuint(UNIVERSAL_BINS[index / 4u]);
    return four[index % 4u];
}

uint TileWord(uint index)
{
    uint4 four = asuint(urp_Tiles[index / 4u]);
    return four[index % 4u];
}

// The lights that may reach a point, one after the other.
struct UniversalLightList
{
    uint directional; // these come first
    uint given;       // lights so far
    uint tileWords;
    uint binWords;
    uint first; // of the bin, as bits
    uint last;
    uint word;  // of the bits that are looked at
    uint bits;  // that are left of it
};

UniversalLightList StartLights(float3 world, float2 screen)
{
    uint words = (uint)_FPParams1.w;
    uint2 at = (uint2)(saturate(screen) * _FPParams1.xy);
    uint tile = at.y * (uint)_FPParams1.z + at.x;
    float depth = -dot(unity_MatrixV[2].xyz, world - _WorldSpaceCameraPos);
    float place = (unity_OrthoParams.w > 0.5 ? depth : log2(max(depth, 1e-6))) * _FPParams0.x + _FPParams0.y;
    uint bin = min((uint)max(place, 0.0), (uint)_FPParams2.x - 1u);
#if defined(STEREO_INSTANCING_ON)
    tile += fluidEye * (uint)_FPParams2.y;
    bin += fluidEye * (uint)_FPParams2.x;
#endif
    bin *= 2u + words;
    uint header = BinWord(bin);

    UniversalLightList list;
    list.directional = min((uint)_FPParams0.w, UNIVERSAL_MOST_LIGHTS);
    list.given = 0u;
    list.tileWords = tile * words;
    list.binWords = bin + 2u;
    list.first = header & 0xFFFFu;
    list.last = header >> 16u;
    list.word = list.first / 32u;
    list.bits = 0u;
    return list;
}

// The number of the next light; false if there is none.
bool NextLight(inout UniversalLightList list, out uint index)
{
    index = list.given;
    if (list.given < list.directional)
    {
        list.given++;
        return true;
    }
    while (list.bits == 0u && list.first <= list.last && list.word <= list.last / 32u)
    {
        list.bits = TileWord(list.tileWords + list.word) & BinWord(list.binWords + list.word);
        uint lowest = list.word * 32u;
        list.bits &= list.first > lowest ? 0xFFFFFFFFu << (list.first - lowest) : 0xFFFFFFFFu;
        list.bits &= list.last - lowest < 31u ? 0xFFFFFFFFu >> (31u - (list.last - lowest)) : 0xFFFFFFFFu;
        list.word++;
    }
    if (list.bits == 0u)
        return false;
    index = list.directional + (list.word - 1u) * 32u + firstbitlow(list.bits);
    list.bits &= list.bits - 1u;
    return true;
}

#else

float4 unity_LightIndices[2];

struct UniversalLightList
{
    uint given;
    uint count;
};

UniversalLightList StartLights(float3 world, float2 screen)
{
    UniversalLightList list;
    list.given = 0u;
    list.count = min((uint)min(_AdditionalLightsCount.x, unity_LightData.y), 8u);
    return list;
}

// The number of the next light; false if there is none.
bool NextLight(inout UniversalLightList list, out uint index)
{
    float4 four = unity_LightIndices[min(list.given / 4u, 1u)];
    index = (uint)four[list.given % 4u];
    list.given++;
    return list.given <= list.count;
}

#endif

#endif

#endif
