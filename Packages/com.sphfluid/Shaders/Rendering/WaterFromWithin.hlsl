// Water seen by a camera in it: the far face of the layer that holds the camera stands for the whole picture, as each line of sight meets
// it, before the scene or behind. Through the surface one sees Snell's window, round it the surface mirrors the water.
#ifndef SPHFLUID_WATER_FROM_WITHIN_INCLUDED
#define SPHFLUID_WATER_FROM_WITHIN_INCLUDED

#include "WaterShading.hlsl"

#define WATER_TO_AIR 1.33333333 // ratio of the refractive indices

// sun: share of the main light that reaches the water in sight.
float3 WaterBody(float metres, float sun)
{
    return (_FluidScattering.rgb * WaterInnerLight(sun) + _FluidEmission.rgb) * (1.0 - exp(-_FluidExtinction.rgb * metres));
}

// Beside the picture it goes on as its mirror image: there is no telling what stands there, but its border drawn out would be streaks.
float2 Unfolded(float2 screen)
{
    return 1.0 - abs(1.0 - abs(screen) % 2.0);
}

// What a line in the water shows at its end, dimmed on its way there.
float3 SeenAlong(WaterRay ray, float longest, float sun)
{
    MarchEnd end = March(ray, longest, (uint)max(_FluidRefractionSteps.x, 4.0));
    float3 scene = SceneColour(Unfolded(RayScreen(ray, end.metres)));
    return scene * exp(-_FluidExtinction.rgb * end.metres) + FluidExposed(WaterBody(end.metres, sun));
}

// What a line in the air shows: the scene, and where it leaves the picture, the sky.
float3 SeenOutside(WaterRay ray)
{
    float3 sky = FluidExposed(WaterMirror(ray.direction));
    MarchEnd end = March(ray, FAR_BEHIND * ray.front / max(abs(ray.depthStep), 0.05), (uint)max(_FluidRefractionSteps.y, 3.0));
    float2 screen = RayScreen(ray, end.metres);
    float share = PictureShare(screen) * (ray.depthStep > 0.0 ? 1.0 : 0.0);
    return lerp(sky, SceneColour(saturate(screen)), share);
}

float4 ShadeFromWithin(SurfaceFragment input) : SV_Target
{
    EYE_OF(input)
    const float3 world = SurfaceWorld(input);
    float2 screen = WaterScreen(world);
    float face = WaterEyeDepth(world);
    float doubt = 4e-3 * max(face, 1.0);
    bool isWithin = UnpairedFaces(screen) > 0.5 && face < FirstLayerEnd(screen) + doubt;
    clip(isWithin ? 1.0 : -1.0);

    float3 sight = -WaterView(world);
    float3 normal = SurfaceNormal(input);
    float alongAxis = max(dot(-sight, normalize(unity_MatrixV[2].xyz)), 1e-3);
    float scene = SceneEyeDepth(screen);
    bool isAtWall = LeaveDomain(world - sight * _MCCellSize.x, sight).metres < 3.0 * _MCCellSize.x;
    float path = min(scene, face) / alongAxis;
    float3 dimmed = exp(-_FluidExtinction.rgb * path);
    float seen = min(path, 1.0 / max(_FluidExtinction.g, 1e-6)); // most of what scatters to the camera does so before
    float sun = WaterSun(world - sight * (face / alongAxis - 0.5 * seen), 0.0);
    float3 body = FluidExposed(WaterBody(path, sun));
    if (_FluidScene.x == WATER_SCENE_NONE)
        return float4(body, 1.0 - dot(dimmed, 1.0 / 3.0));

    float3 light = 0.0;
    if (scene < face + (isAtWall ? WALL_CONTACT : doubt))
    {
        light = SceneColour(screen);
    }
    else
    {
        float3 bent = refract(sight, -normal, WATER_TO_AIR);
        if (dot(bent, bent) < 0.5)
        {
            WaterRay mirrored = StartRay(world, reflect(sight, normal));
            light = SeenAlong(mirrored, LeaveDomain(mirrored.start, mirrored.direction).metres, sun);
        }
        else
        {
            float reflected = FluidFresnel(normal, bent, _FluidEmission.w);
            light = SeenOutside(StartRay(world, bent)) * (1.0 - reflected) + FluidExposed(WaterBody(NOTHING_BEHIND, sun)) * reflected;
        }
    }
    return float4(light * dimmed + body, 1.0);
}

#endif
