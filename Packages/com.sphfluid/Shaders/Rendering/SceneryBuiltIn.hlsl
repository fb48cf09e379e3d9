// Scenery in the Built-in pipeline, with Unity's documented macros for cast and received shadows.
#ifndef SPHFLUID_SCENERY_BUILT_IN_INCLUDED
#define SPHFLUID_SCENERY_BUILT_IN_INCLUDED

#include "UnityCG.cginc"
#include "AutoLight.cginc"
#include "SceneryShading.hlsl"

float4 _LightColor0;

// The macros read v.vertex and v.normal and write o.pos.
struct SceneryVertex
{
    float4 vertex : POSITION;
    float3 normal : NORMAL;
};

struct SceneryFragment
{
    float4 pos : SV_POSITION;
    float3 world : TEXCOORD0;
    float3 normal : TEXCOORD1;
    SHADOW_COORDS(2)
};

SceneryFragment PlaceScenery(SceneryVertex v)
{
    SceneryFragment o;
    o.pos = UnityObjectToClipPos(v.vertex.xyz);
    o.world = mul(unity_ObjectToWorld, v.vertex).xyz;
    o.normal = UnityObjectToWorldNormal(v.normal);
    TRANSFER_SHADOW(o);
    return o;
}

float4 ShadeScenery(SceneryFragment i) : SV_Target
{
    float3 normal = normalize(i.normal);
    float3 view = normalize(_WorldSpaceCameraPos.xyz - i.world);
    float visible = SHADOW_ATTENUATION(i);
    float3 colour = SceneryReflection(normal, view, _WorldSpaceLightPos0.xyz) * _LightColor0.rgb * visible;
    return float4(colour + SceneryAmbientReflection(normal, view), 1.0);
}

struct ShadowFragment
{
    V2F_SHADOW_CASTER;
};

ShadowFragment PlaceSceneryShadow(SceneryVertex v)
{
    ShadowFragment o;
    TRANSFER_SHADOW_CASTER_NORMALOFFSET(o)
    return o;
}

float4 CastSceneryShadow(ShadowFragment i) : SV_Target
{
    SHADOW_CASTER_FRAGMENT(i)
}

#endif
