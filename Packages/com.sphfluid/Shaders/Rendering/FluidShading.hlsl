// Camera, light and lighting that the drawings share, for every render pipeline. No include of any pipeline: the camera's matrices have the
// same names in all of them, the light comes from the component (SceneLighting.cs).
#ifndef SPHFLUID_SHADING_INCLUDED
#define SPHFLUID_SHADING_INCLUDED

// Only OpenGL has depth 0 at the near plane; every other API, those to come included, has 1 there.
#if !defined(SHADER_API_GLCORE) && !defined(SHADER_API_GLES3) && !defined(SHADER_API_GLES)
#define FLUID_REVERSED_Z 1
#endif

#include "Eyes.hlsl"

float4 unity_LightShadowBias; // Built-in; x: depth bias in clip space, y: 1 for directional lights

float4x4 _FluidLocalToWorld;  // simulation space to world space: rotation and translation
float4 _FluidLightDirection;  // xyz: unit vector to the main light, world space
float4 _FluidLightColour;     // rgb: colour times intensity of the main light, in the colours that shaders use
float4 _FluidAmbient[7];      // ambient light, spherical harmonics of order 2: SHAr, SHAg, SHAb, SHBr, SHBg, SHBb, SHC
float _FluidShadowClamp;      // 1: shadow casters stay behind the light's near plane, whatever unity_LightShadowBias says

#define WATER_REFLECTANCE 0.02 // Fresnel at normal incidence, ((n - 1) / (n + 1))^2 at n = 1.33

float3 FluidWorldPosition(float3 local)
{
    return mul(_FluidLocalToWorld, float4(local, 1.0)).xyz;
}

// Where simulation space has its origin in the world.
float3 FluidOrigin()
{
    return float3(_FluidLocalToWorld[0].w, _FluidLocalToWorld[1].w, _FluidLocalToWorld[2].w);
}

float3 FluidWorldDirection(float3 local)
{
    return mul((float3x3)_FluidLocalToWorld, local);
}

// From world space back to simulation space.
float3 FluidLocalPosition(float3 world)
{
    return mul(transpose((float3x3)_FluidLocalToWorld), world - FluidOrigin());
}

float3 FluidLocalDirection(float3 world)
{
    return mul(transpose((float3x3)_FluidLocalToWorld), world);
}

#if defined(FLUID_HDRP)

Texture2D<float4> _ExposureTexture; // HDRP's exposure, one pixel

// Where the view matrix has its eye: V p = R p + t, so -R^T t. That is the camera, or the origin where matrices are camera-relative.
float3 FluidMatrixEye()
{
    return -mul(float3(unity_MatrixV[0].w, unity_MatrixV[1].w, unity_MatrixV[2].w), (float3x3)unity_MatrixV);
}

// E.g. a camera at (9, 0, 0) and a point at (10, 0, 0): (1, 0, 0) if the matrices are camera-relative, else (10, 0, 0).
float3 FluidMatrixPosition(float3 world)
{
    return (world - _WorldSpaceCameraPos) + FluidMatrixEye();
}

// HDRP counts light in lux, which a matt surface sends back by 1 / pi, and exposes it here.
float3 FluidLampColour()
{
    return _FluidLightColour.rgb / 3.14159265;
}

float3 FluidExposed(float3 colour)
{
    return colour * _ExposureTexture.Load(int3(0, 0, 0)).x;
}

#else

float3 FluidMatrixPosition(float3 world)
{
    return world;
}

float3 FluidLampColour()
{
    return _FluidLightColour.rgb;
}

float3 FluidExposed(float3 colour)
{
    return colour;
}

#endif

float4 FluidClipPosition(float3 world)
{
    return mul(unity_MatrixVP, float4(FluidMatrixPosition(world), 1.0));
}

// The same of a place in simulation space. At 10 km from the origin places in the world have steps of 1 mm, so the way from the domain's
// middle is projected apart; what rounding is left moves all of a picture alike.
float4 FluidClipOfLocal(float3 local, float3 worldOffset)
{
    return mul(unity_MatrixVP, float4(FluidWorldDirection(local) + worldOffset, 0.0)) + FluidClipPosition(FluidOrigin());
}

// Width of a pixel at a point [m]. height: of the picture, pixels.
float FluidPixelWidth(float3 world, float height)
{
    float across = length(float3(unity_MatrixVP[1].x, unity_MatrixVP[1].y, unity_MatrixVP[1].z));
    return 2.0 * FluidClipPosition(world).w / (across * max(height, 1.0));
}

// Moves a shadow caster away from the light, but never in front of the light's near plane.
float4 FluidShadowClipPosition(float4 clipPosition)
{
#if defined(FLUID_REVERSED_Z)
    clipPosition.z += max(-1.0, min(unity_LightShadowBias.x / clipPosition.w, 0.0));
    float clamped = min(clipPosition.z, clipPosition.w);
#else
    clipPosition.z += saturate(unity_LightShadowBias.x / clipPosition.w);
    float clamped = max(clipPosition.z, -clipPosition.w);
#endif
    clipPosition.z = lerp(clipPosition.z, clamped, max(unity_LightShadowBias.y, _FluidShadowClamp));
    return clipPosition;
}

// The scene's ambient light from a direction: spherical harmonics of order 2 as Unity lays them out.
float3 FluidAmbient(float3 direction)
{
    float4 n = float4(direction, 1.0);
    float4 products = n.xyzz * n.yzzx;
    float3 light = float3(dot(_FluidAmbient[0], n), dot(_FluidAmbient[1], n), dot(_FluidAmbient[2], n));
    light += float3(dot(_FluidAmbient[3], products), dot(_FluidAmbient[4], products), dot(_FluidAmbient[5], products));
    light += _FluidAmbient[6].xyz * (n.x * n.x - n.y * n.y);
    light = max(light, 0.0);
#if defined(UNITY_COLORSPACE_GAMMA)
    light = max(1.055 * pow(light, 1.0 / 2.4) - 0.055, 0.0);
#endif
    return light;
}

// Lambert's diffuse light of the main light plus the ambient light. sun: share of the main light that arrives, ReceivedShadow.hlsl.
float3 FluidDiffuse(float3 albedo, float3 normal, float sun)
{
    float lit = saturate(dot(normal, _FluidLightDirection.xyz)) * sun;
    return albedo * (FluidLampColour() * lit + FluidAmbient(normal));
}

// Blinn-Phong with its energy factor (n + 8) / 8; smoothness 0...1 stands for exponents 2...2048.
// variance: of the normal over a pixel; it lowers the exponent, so that highlights smaller than a pixel do not sparkle (Kaplanyan et al.
// 2016). reflectance: at a right angle.
float3 FluidHighlight(float smoothness, float3 normal, float3 view, float variance, float reflectance)
{
    float3 light = _FluidLightDirection.xyz;
    float exponent = exp2(1.0 + 10.0 * smoothness);
    exponent /= 1.0 + exponent * variance;
    float facing = saturate(dot(normal, normalize(light + view)));
    float lit = saturate(dot(normal, light));
    return FluidLampColour() * (lit * reflectance * (exponent + 8.0) / 8.0 * pow(facing, exponent));
}

float3 FluidHighlight(float smoothness, float3 normal, float3 view)
{
    return FluidHighlight(smoothness, normal, view, 0.0, WATER_REFLECTANCE);
}

// Schlick's approximation: how much of the light from the mirror direction a smooth surface reflects.
float FluidFresnel(float3 normal, float3 view, float reflectance)
{
    float grazing = 1.0 - saturate(dot(normal, view));
    float squared = grazing * grazing;
    return reflectance + (1.0 - reflectance) * squared * squared * grazing;
}

float FluidFresnel(float3 normal, float3 view)
{
    return FluidFresnel(normal, view, WATER_REFLECTANCE);
}

#endif
