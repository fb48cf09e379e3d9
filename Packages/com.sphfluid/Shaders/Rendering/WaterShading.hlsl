// Clear water: refracted scene, absorption and scattering along the path, mirror of the surroundings, highlight of the sun.
#ifndef SPHFLUID_WATER_SHADING_INCLUDED
#define SPHFLUID_WATER_SHADING_INCLUDED

#include "SurfaceDrawing.hlsl"
#include "WaterRefraction.hlsl"

EYE_TEXTURE<float4> _FluidSceneColour;    // Built-in: a copy of the camera's picture before transparent things
EYE_TEXTURE<float4> _CameraOpaqueTexture; // URP
float4 _FluidExtinction; // rgb: light lost per metre, absorbed or scattered [1/m]
float4 _FluidScattering; // rgb: of that, scattered, 0 to 1; w: how much it is lit as a matt body, 0 to 1
float4 _FluidEmission;   // rgb: light that a thick layer gives off; w: share that the surface mirrors at a right angle
TextureCube<float4> _FluidReflectionMap;
float4 _FluidReflection;       // x: 1 with a map, 0 without; y: mip level; z: 1 if a black map means one that was never made
float4 _FluidReflectionDecode; // as Unity decodes HDR pictures, intensity included
float _Smoothness;
float _ShadowStrength; // light that the shadow takes away, 0 to 1

#define COARSEST_LEVEL 16.0 // beyond the last of any map, which stands for it

#define SKIN 0.95 // light that a flat skin keeps back
#define LEAST_MIRRORED 0.03 // Fresnel's share, below which the scene is not looked for

#define SAME_DEPTH 0.02 // of the depth; within it things count as one

// URP may halve or quarter its picture of the scene, whose pixels then mix what stands at an edge with what is behind it. Of the four
// around a place those count whose middle lies as deep as the place, or all where none does.
float3 CoarseSceneColour(float2 screen, float2 size)
{
    float depth = SceneEyeDepth(screen);
    float2 first = floor(screen * size - 0.5);
    float2 within = screen * size - 0.5 - first;
    float4 sum = 0.0;
    [loop]
    for (uint i = 0u; i < 4u; i++)
    {
        float2 corner = float2(i % 2u, i / 2u);
        float2 place = (first + corner + 0.5) / size;
        float2 near = lerp(1.0 - within, within, corner);
        float apart = abs(SceneEyeDepth(place) - depth) / (SAME_DEPTH * depth);
        float weight = near.x * near.y * max(saturate(1.0 - apart), 1e-3) + 1e-6;
        sum += float4(_CameraOpaqueTexture.SampleLevel(sampler_PointClamp, EyePlace(place), 0.0).rgb, 1.0) * weight;
    }
    return sum.rgb / sum.w;
}

float3 SceneColour(float2 screen)
{
    float3 colour = 0.0;
    [branch]
    if (_FluidScene.x == WATER_SCENE_COPY)
    {
        colour = _FluidSceneColour.SampleLevel(sampler_LinearClamp, EyePlace(screen), 0.0).rgb;
    }
    else
    {
        float2 size = 1.0;
        float2 whole = 1.0;
        EYE_TEXTURE_SIZE(_CameraOpaqueTexture, size)
        EYE_TEXTURE_SIZE(_CameraDepthTexture, whole)
        [branch]
        if (size.x < whole.x)
            colour = CoarseSceneColour(screen, size);
        else
            colour = _CameraOpaqueTexture.SampleLevel(sampler_LinearClamp, EyePlace(screen), 0.0).rgb;
    }
    return colour;
}

// Share of the main light that reaches a point of the water or its surface.
float WaterSun(float3 world, float3 normal)
{
    return ReceivedSun(world, normal, SURFACE_LIFT, _ShadowStrength);
}

// Light that a metre's worth of scattering sends to the camera: half of what comes from above, as water sends it forwards and back alike.
float3 WaterInnerLight(float sun)
{
    float3 up = float3(0.0, 1.0, 0.0);
    return 0.5 * (FluidLampColour() * (saturate(_FluidLightDirection.y) * sun) + FluidAmbient(up));
}

// What is mirrored: the scene's reflection probe or sky where there is one, else the ambient light. Without lighting data Unity 6 hands
// over a black sky.
float3 WaterMirror(float3 direction)
{
    float3 colour = FluidAmbient(direction);
    if (_FluidReflection.x > 0.0)
    {
        float4 encoded = _FluidReflectionMap.SampleLevel(sampler_LinearClamp, direction, _FluidReflection.y);
        float alpha = _FluidReflectionDecode.w * (encoded.a - 1.0) + 1.0;
#if defined(UNITY_COLORSPACE_GAMMA)
        float3 mirrored = encoded.rgb * (_FluidReflectionDecode.x * alpha);
#else
        float3 mirrored = encoded.rgb * (_FluidReflectionDecode.x * pow(max(alpha, 0.0), _FluidReflectionDecode.y));
#endif
        float3 whole = _FluidReflectionMap.SampleLevel(sampler_LinearClamp, direction, COARSEST_LEVEL).rgb;
        colour = dot(whole, 1.0) > 0.0 || _FluidReflection.z == 0.0 ? mirrored : colour;
    }
    return colour;
}

// Variance of the normal over a pixel.
float NormalVariance(float3 normal)
{
    float3 across = ddx(normal);
    float3 along = ddy(normal);
    return min(0.5 * (dot(across, across) + dot(along, along)), 0.25);
}

// Its own light. A liquid of a short sight has a skin that cools where it lies flat and tears where it falls steeply, as lava has: there it
// is brighter, in its weaker colours most.
float3 WaterGlow(float3 normal)
{
    float open = 1.0 - SKIN * _FluidScattering.w * saturate(normal.y);
    float3 share = _FluidEmission.rgb / max(max(_FluidEmission.r, max(_FluidEmission.g, _FluidEmission.b)), 1e-6);
    return _FluidEmission.rgb * open * lerp(open, 1.0, share);
}

// What a layer sends to the camera: light that it scatters, and its own. A liquid of a short sight scatters near where light enters, so
// that it is lit by how its surface faces the light.
float3 WaterLayer(float3 transmitted, float3 normal, float sun)
{
    float3 light = lerp(WaterInnerLight(sun), FluidDiffuse(1.0, normal, sun), _FluidScattering.w);
    return (_FluidScattering.rgb * light + WaterGlow(normal)) * (1.0 - transmitted);
}

float4 ShadeWater(SurfaceFragment input) : SV_Target
{
    EYE_OF(input)
    const float3 world = SurfaceWorld(input);
    float3 view = WaterView(world);
    float3 normal = SurfaceNormal(input);
    float mirrored = FluidFresnel(normal, view, _FluidEmission.w);
    bool mirrors = _FluidRefractionSteps.w > 0.5 && _FluidScene.x != WATER_SCENE_NONE && mirrored > LEAST_MIRRORED;
    SeenThrough seen = SeeThrough(world, view, normal, mirrors);

    float3 transmitted = exp(-_FluidExtinction.rgb * seen.path);
    float sun = WaterSun(world, normal);
    float3 body = WaterLayer(transmitted, normal, sun);
    float3 highlight = FluidHighlight(_Smoothness, normal, view, NormalVariance(normal), _FluidEmission.w) * sun;
    float3 surroundings = FluidExposed(WaterMirror(reflect(-view, normal)));
    float share = PictureShare(seen.mirror);
    [branch]
    if (share > 0.0)
        surroundings = lerp(surroundings, SceneColour(seen.mirror), share);
    float3 colour = FluidExposed(body * (1.0 - mirrored) + highlight) + surroundings * mirrored;
    float cover = 1.0;
    if (_FluidScene.x == WATER_SCENE_NONE)
        cover = 1.0 - (1.0 - mirrored) * dot(transmitted, 1.0 / 3.0);
    else
        colour += SceneColour(seen.screen) * transmitted * (1.0 - mirrored);
    return float4(colour, cover);
}

// A shadow map stores full shadow or none. To let part of the light through, a pattern leaves out that share of each three by three texels,
// and the filters of soft shadows blur it to an even half-shadow. Filters that average three texels, or five in a tent, show no pattern.
float4 CastWaterShadow(SurfaceFragment input) : SV_Target
{
    uint2 texel = (uint2)input.clipPosition.xy % 3u;
    float rank = (float)(3u * ((texel.x + texel.y) % 3u) + texel.y);
    clip(FilledTexels(_ShadowStrength) - rank - 0.5);
    return 0.0;
}

#endif
