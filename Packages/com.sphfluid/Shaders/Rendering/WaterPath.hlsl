// How far a line of sight runs through water.
#ifndef SPHFLUID_WATER_PATH_INCLUDED
#define SPHFLUID_WATER_PATH_INCLUDED

#include "../Surface/SurfaceFragment.hlsl"

float4 _ProjectionParams; // x: -1 where the picture is drawn upside down
float4 _ZBufferParams;
float4 unity_OrthoParams; // w: 1 for an orthographic camera

#if defined(STEREO_INSTANCING_ON)
#define _FluidThickness _FluidThicknessEyes
#endif

EYE_TEXTURE<float4> _FluidThickness;  // WaterThickness.hlsl
EYE_TEXTURE<float> _CameraDepthTexture;
SamplerState sampler_LinearClamp;
SamplerState sampler_PointClamp;
float4 _FluidThicknessSize; // xy: pixels of _FluidThickness; z: pixels of the picture to one of its, along an axis
float4 _FluidThicknessView; // xy: pixels of the camera's picture
float4 _FluidScene;         // x: where the scene's colour is, WATER_SCENE_*; y: 1 if _CameraDepthTexture is there

#define WATER_SCENE_NONE 0.0      // SceneTextures.cs
#define WATER_SCENE_COPY 1.0
#define WATER_SCENE_UNIVERSAL 2.0
#define NOTHING_BEHIND 1e6 // metres

// Unit vector to the camera.
float3 WaterView(float3 world)
{
    return unity_OrthoParams.w > 0.5 ? normalize(unity_MatrixV[2].xyz) : normalize(_WorldSpaceCameraPos - world);
}

// 0 to 1 over the camera's picture, from its lower left corner.
float2 WaterScreen(float3 world)
{
    float4 clipPosition = FluidClipPosition(world);
    return clipPosition.xy / clipPosition.w * float2(0.5, 0.5 * _ProjectionParams.x) + 0.5;
}

// Metres along the camera's axis.
float WaterEyeDepth(float3 world)
{
    return -dot(unity_MatrixV[2], float4(FluidMatrixPosition(world), 1.0));
}

// From what a depth texture holds to metres along the camera's axis.
float EyeDepthOf(float raw)
{
    float near = _ProjectionParams.y;
    float far = _ProjectionParams.z;
#if defined(FLUID_REVERSED_Z)
    float between = 1.0 - raw;
#else
    float between = raw;
#endif
    return unity_OrthoParams.w > 0.5 ? lerp(near, far, between) : 1.0 / (_ZBufferParams.z * raw + _ZBufferParams.w);
}

float SceneEyeDepth(float2 screen)
{
    float depth = NOTHING_BEHIND;
    if (_FluidScene.y > 0.5)
        depth = EyeDepthOf(_CameraDepthTexture.SampleLevel(sampler_PointClamp, EyePlace(screen), 0.0));
    return depth;
}

// The nearest of the four texels that a filtered colour there is mixed of.
float NearestSceneDepth(float2 screen)
{
    float depth = NOTHING_BEHIND;
    if (_FluidScene.y > 0.5)
    {
        float4 raw = _CameraDepthTexture.GatherRed(sampler_PointClamp, EyePlace(screen));
#if defined(FLUID_REVERSED_Z)
        depth = EyeDepthOf(max(max(raw.x, raw.y), max(raw.z, raw.w)));
#else
        depth = EyeDepthOf(min(min(raw.x, raw.y), min(raw.z, raw.w)));
#endif
    }
    return depth;
}

// Of the plane through these four texels: what a depth texture holds of a plane is linear on the screen. The place between them is asked
// for, as devices round near a texel's middle.
float SmoothSceneDepth(float2 screen)
{
    float depth = NOTHING_BEHIND;
    if (_FluidScene.y > 0.5)
    {
        float2 size = 1.0;
        EYE_TEXTURE_SIZE(_CameraDepthTexture, size)
        float2 first = floor(screen * size - 0.5);
        float2 within = screen * size - 0.5 - first;
        float4 raw = _CameraDepthTexture.GatherRed(sampler_PointClamp, EyePlace((first + 1.0) / size));
        float2 rows = lerp(raw.wx, raw.zy, within.x);
        depth = EyeDepthOf(lerp(rows.x, rows.y, within.y));
    }
    return depth;
}

// Where the line of sight enters and leaves the domain, metres along the camera's axis.
float2 DomainSpan(float3 world, float3 view, float alongAxis)
{
    float3 position = FluidLocalPosition(world);
    float3 direction = FluidLocalDirection(-view);
    float3 reciprocal = 1.0 / (abs(direction) > 1e-6 ? direction : (float3)1e-6);
    float3 a = (_MCMinimum - position) * reciprocal;
    float3 b = (_MCMinimum + _MCCells * _MCCellSize - position) * reciprocal;
    float3 entries = min(a, b);
    float3 exits = max(a, b);
    float entry = max(max(entries.x, entries.y), entries.z);
    float exit = min(min(exits.x, exits.y), exits.z);
    return max(WaterEyeDepth(world) + float2(entry, exit) * alongAxis, 0.0);
}

// What the thickness picture holds at a place of the camera's picture, which fills its lower left part.
float4 ThicknessAt(SamplerState filter, float2 screen)
{
    float2 part = ceil(_FluidThicknessView.xy / _FluidThicknessSize.z);
    float2 used = min(part / _FluidThicknessSize.xy, 1.0);
    float2 place = min(screen * used, used - 0.5 / _FluidThicknessSize.xy);
    return _FluidThickness.SampleLevel(filter, EyePlace(place), 0.0);
}

// Far faces less near faces on a line of sight: 1 where it starts in water.
float UnpairedFaces(float2 screen)
{
    return ThicknessAt(sampler_PointClamp, screen).y;
}

// What a texel of the thickness picture tells of the nearest layer's end, metres along the camera's axis; negative where there is no layer.
float FirstLayerEndOf(float4 thickness)
{
    return thickness.w > -999.0 ? WaterEyeDepth(FluidWorldPosition(0.0)) - thickness.w : -1.0;
}

float FirstLayerEnd(float2 screen)
{
    return FirstLayerEndOf(ThicknessAt(sampler_PointClamp, screen));
}

// Between texels, where they hold one face.
float SmoothFirstLayerEnd(float2 screen)
{
    float end = FirstLayerEnd(screen);
    float between = FirstLayerEndOf(ThicknessAt(sampler_LinearClamp, screen));
    return abs(between - end) < _MCCellSize.x ? between : end;
}

// Where the nearest layer begins and ends, metres along the camera's axis. Before further layers it begins at or behind the place that is
// told, which holds the water of them all; where faces lack partners that place is the camera. Worked example: a film from 1.90 to 1.91 m
// gives (1.90, 1.91), with a layer from 2.5 to 2.6 m behind it (1.80, 1.91).
float2 FirstLayerSpan(float2 screen)
{
    float4 thickness = ThicknessAt(sampler_PointClamp, screen);
    float end = FirstLayerEndOf(thickness);
    return float2(abs(thickness.y) < 0.5 ? end - thickness.x : 0.0, end);
}

// Where the water begins, metres along the camera's axis; NOTHING_BEHIND where there is none. Of several layers only the end of the nearest
// is known, which stands for its beginning: mist before it fades too late rather than too early.
float NearestWater(float2 screen)
{
    float4 thickness = ThicknessAt(sampler_PointClamp, screen);
    float end = FirstLayerEndOf(thickness);
    bool isOnly = abs(thickness.y) < 0.5 && thickness.z < 1.5;
    return end < 0.0 ? NOTHING_BEHIND : isOnly ? end - thickness.x : end;
}

// Whether a camera in the water sees a point of the picture that lies beyond the water's surface. The picture of the scene that the water
// refracts holds it then, so that it is neither drawn twice nor where a straight line would meet it.
bool IsBeyondSurfaceFromWithin(float2 screen, float depth)
{
    return _FluidScene.x != WATER_SCENE_NONE && UnpairedFaces(screen) > 0.5 && depth > FirstLayerEnd(screen);
}

// How thick the nearest layer is behind a point of the surface, metres along the camera's axis. Half floats place its end to a millimetre.
float FirstLayer(float2 screen, float front)
{
    float end = FirstLayerEnd(screen);
    return end > front - 2e-3 ? max(end - front, 0.0) : NOTHING_BEHIND;
}

// Water behind a point of the surface, metres along the camera's axis. A surface that is open at the walls, or a camera within the water,
// leaves faces without a partner: the domain's wall, or the camera, takes its place.
float WaterBehind(float3 world, float3 view, float alongAxis)
{
    float2 sums = ThicknessAt(sampler_LinearClamp, WaterScreen(world)).xy;
    float2 span = DomainSpan(world, view, alongAxis);
    float unpaired = sums.y > 0.0 ? span.x : span.y;
    return max(sums.x + sums.y * (WaterEyeDepth(FluidWorldPosition(0.0)) - unpaired), 0.0);
}

#endif
