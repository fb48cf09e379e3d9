// Light and camera of Unity's Built-in pipeline under their own names, and the lighting that the drawings share. No include of Unity's.
#ifndef SPHFLUID_SHADING_INCLUDED
#define SPHFLUID_SHADING_INCLUDED

#if defined(SHADER_API_D3D11) || defined(SHADER_API_D3D12) || defined(SHADER_API_VULKAN) || defined(SHADER_API_METAL) || defined(SHADER_API_PSSL) || defined(SHADER_API_SWITCH)
#define FLUID_REVERSED_Z 1
#endif

float4x4 unity_MatrixV;
float4x4 unity_MatrixVP;
float3 _WorldSpaceCameraPos;
float4 _WorldSpaceLightPos0; // ForwardBase: direction to the light (w = 0) or its position (w = 1)
float4 _LightColor0;
float4 unity_LightShadowBias; // x: depth bias in clip space, y: 1 for directional lights
float4 unity_SHAr;
float4 unity_SHAg;
float4 unity_SHAb;
float4 unity_SHBr;
float4 unity_SHBg;
float4 unity_SHBb;
float4 unity_SHC;

float4x4 _FluidLocalToWorld; // simulation space to world space: rotation and translation

#define WATER_REFLECTANCE 0.02 // Fresnel at normal incidence, ((n - 1) / (n + 1))^2 at n = 1.33

float3 FluidWorldPosition(float3 local)
{
    return mul(_FluidLocalToWorld, float4(local, 1.0)).xyz;
}

float3 FluidWorldDirection(float3 local)
{
    return mul((float3x3)_FluidLocalToWorld, local);
}

float4 FluidClipPosition(float3 world)
{
    return mul(unity_MatrixVP, float4(world, 1.0));
}

// Moves a shadow caster away from the light, but never in front of the light's near plane.
float4 FluidShadowClipPosition(float3 world)
{
    float4 clipPosition = FluidClipPosition(world);
#if defined(FLUID_REVERSED_Z)
    clipPosition.z += max(-1.0, min(unity_LightShadowBias.x / clipPosition.w, 0.0));
    float clamped = min(clipPosition.z, clipPosition.w);
#else
    clipPosition.z += saturate(unity_LightShadowBias.x / clipPosition.w);
    float clamped = max(clipPosition.z, -clipPosition.w);
#endif
    clipPosition.z = lerp(clipPosition.z, clamped, unity_LightShadowBias.y);
    return clipPosition;
}

// The scene's ambient light from a direction: spherical harmonics of order 2 as Unity lays them out.
float3 FluidAmbient(float3 direction)
{
    float4 n = float4(direction, 1.0);
    float4 products = n.xyzz * n.yzzx;
    float3 light = float3(dot(unity_SHAr, n), dot(unity_SHAg, n), dot(unity_SHAb, n));
    light += float3(dot(unity_SHBr, products), dot(unity_SHBg, products), dot(unity_SHBb, products));
    light += unity_SHC.xyz * (n.x * n.x - n.y * n.y);
    light = max(light, 0.0);
#if defined(UNITY_COLORSPACE_GAMMA)
    light = max(1.055 * pow(light, 1.0 / 2.4) - 0.055, 0.0);
#endif
    return light;
}

float3 FluidLightDirection(float3 world)
{
    return normalize(_WorldSpaceLightPos0.xyz - world * _WorldSpaceLightPos0.w);
}

// Lambert's diffuse light of one lamp plus the ambient light.
float3 FluidDiffuse(float3 albedo, float3 normal, float3 world)
{
    float lit = saturate(dot(normal, FluidLightDirection(world)));
    return albedo * (_LightColor0.rgb * lit + FluidAmbient(normal));
}

// Blinn-Phong with its energy factor (n + 8) / 8; smoothness 0...1 stands for exponents 2...2048.
float3 FluidHighlight(float smoothness, float3 normal, float3 view, float3 world)
{
    float3 light = FluidLightDirection(world);
    float exponent = exp2(1.0 + 10.0 * smoothness);
    float facing = saturate(dot(normal, normalize(light + view)));
    float lit = saturate(dot(normal, light));
    return _LightColor0.rgb * (lit * WATER_REFLECTANCE * (exponent + 8.0) / 8.0 * pow(facing, exponent));
}

// Schlick's approximation: how much of the light from the mirror direction a smooth water surface reflects.
float FluidFresnel(float3 normal, float3 view)
{
    float grazing = 1.0 - saturate(dot(normal, view));
    float squared = grazing * grazing;
    return WATER_REFLECTANCE + (1.0 - WATER_REFLECTANCE) * squared * squared * grazing;
}

#endif
