// Scenery in the Built-in pipeline, with Unity's macros for cast and received shadows and for the reach of lights.
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
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct SceneryFragment
{
    float4 pos : SV_POSITION;
    float3 world : TEXCOORD0;
    float3 normal : TEXCOORD1;
#if defined(UNITY_PASS_FORWARDADD)
    UNITY_LIGHTING_COORDS(2, 3)
#else
    SHADOW_COORDS(2)
#endif
#if defined(VERTEXLIGHT_ON)
    float3 vertexLight : TEXCOORD3; // of lights that are not drawn per pixel
#endif
    UNITY_VERTEX_OUTPUT_STEREO
};

SceneryFragment PlaceScenery(SceneryVertex v)
{
    SceneryFragment o;
    UNITY_SETUP_INSTANCE_ID(v);
    UNITY_INITIALIZE_OUTPUT(SceneryFragment, o);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(o);
    o.pos = UnityObjectToClipPos(v.vertex.xyz);
    o.world = mul(unity_ObjectToWorld, v.vertex).xyz;
    o.normal = UnityObjectToWorldNormal(v.normal);
#if defined(UNITY_PASS_FORWARDADD)
    UNITY_TRANSFER_LIGHTING(o, float2(0.0, 0.0));
#else
    TRANSFER_SHADOW(o);
#endif
#if defined(VERTEXLIGHT_ON)
    o.vertexLight = Shade4PointLights(
        unity_4LightPosX0, unity_4LightPosY0, unity_4LightPosZ0,
        unity_LightColor[0].rgb, unity_LightColor[1].rgb, unity_LightColor[2].rgb, unity_LightColor[3].rgb,
        unity_4LightAtten0, o.world, o.normal);
#endif
    return o;
}

float4 ShadeScenery(SceneryFragment i) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(i);
    float3 normal = normalize(i.normal);
    float3 view = normalize(_WorldSpaceCameraPos.xyz - i.world);
    float visible = SHADOW_ATTENUATION(i);
    float3 own = SceneryColour(i.world, normal);
    float3 colour = SceneryReflection(own, normal, view, _WorldSpaceLightPos0.xyz) * _LightColor0.rgb * visible;
#if defined(VERTEXLIGHT_ON)
    colour += SceneryDiffuse(own, i.vertexLight);
#endif
    colour += SceneryAmbientReflection(own, normal, view);
    return float4(lerp(colour, _FadeColor.rgb, SceneryFade(i.world, _WorldSpaceCameraPos.xyz)), 1.0);
}

float4 AddLight(SceneryFragment i) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(i);
    float3 normal = normalize(i.normal);
    float3 view = normalize(_WorldSpaceCameraPos.xyz - i.world);
    float3 light = normalize(UnityWorldSpaceLightDir(i.world));
    UNITY_LIGHT_ATTENUATION(visible, i, i.world);
    float3 colour = SceneryReflection(SceneryColour(i.world, normal), normal, view, light) * _LightColor0.rgb * visible;
    return float4(colour * (1.0 - SceneryFade(i.world, _WorldSpaceCameraPos.xyz)), 1.0);
}

struct ShadowFragment
{
    V2F_SHADOW_CASTER;
    UNITY_VERTEX_OUTPUT_STEREO // the camera's depth texture is drawn by this pass, too
};

ShadowFragment PlaceSceneryShadow(SceneryVertex v)
{
    ShadowFragment o;
    UNITY_SETUP_INSTANCE_ID(v);
    UNITY_INITIALIZE_OUTPUT(ShadowFragment, o);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(o);
    TRANSFER_SHADOW_CASTER_NORMALOFFSET(o)
    return o;
}

float4 CastSceneryShadow(ShadowFragment i) : SV_Target
{
    SHADOW_CASTER_FRAGMENT(i)
}

#endif
