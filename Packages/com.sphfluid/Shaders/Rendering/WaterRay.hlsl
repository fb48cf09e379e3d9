// A line of light followed through the picture of the scene's depth, to what is seen there.
#ifndef SPHFLUID_WATER_RAY_INCLUDED
#define SPHFLUID_WATER_RAY_INCLUDED

#include "WaterPath.hlsl"

#define MARCH_HALVINGS 6
#define STEP_PIXELS 4.0   // the shortest step on the screen
#define EDGE_PIXELS 2.0   // beside an edge that have a share of what stands before it
#define PICTURE_MARGIN 0.1 // share of the picture over which it yields to what lies beside it
#define DEPTH_DOUBT 6e-3 // of the depth

struct WaterRay
{
    float4 clipStart;
    float4 clipStep;
    float3 start;     // world space
    float3 direction; // world space, unit length
    float front;      // depth of its start, metres along the camera's axis
    float depthStep;  // depth a metre
};

WaterRay StartRay(float3 world, float3 direction)
{
    WaterRay ray;
    ray.clipStart = FluidClipPosition(world);
    ray.clipStep = mul(unity_MatrixVP, float4(direction, 0.0));
    ray.start = world;
    ray.direction = direction;
    ray.front = WaterEyeDepth(world);
    ray.depthStep = -dot(unity_MatrixV[2].xyz, direction);
    return ray;
}

float2 RayScreen(WaterRay ray, float metres)
{
    float4 clipPosition = ray.clipStart + ray.clipStep * metres;
    return clipPosition.xy / clipPosition.w * float2(0.5, 0.5 * _ProjectionParams.x) + 0.5;
}

float RayDepth(WaterRay ray, float metres)
{
    return ray.front + ray.depthStep * metres;
}

// How far the scene lies behind a point of the line, metres along the camera's axis; negative: in front, by more than pixels and their
// depths are off: what stands at a wall, such as a tank's frame, is not in front of it.
float GapBehind(WaterRay ray, float metres)
{
    float depth = RayDepth(ray, metres);
    return NearestSceneDepth(RayScreen(ray, metres)) + DEPTH_DOUBT * depth - depth;
}

// A gap that is linear on the screen where the scene is a plane, and as large as it is in metres near the line's start.
float ScreenGap(WaterRay ray, float metres, float scene)
{
    float depth = max(RayDepth(ray, metres), 1e-3);
    return unity_OrthoParams.w > 0.5 ? scene - depth : ray.front * ray.front * (1.0 / depth - 1.0 / scene);
}

// With the doubt of GapBehind.
float MarchGap(WaterRay ray, float metres)
{
    return ScreenGap(ray, metres, NearestSceneDepth(RayScreen(ray, metres)) + DEPTH_DOUBT * RayDepth(ray, metres));
}

float PlaneGap(WaterRay ray, float metres)
{
    return ScreenGap(ray, metres, SmoothSceneDepth(RayScreen(ray, metres)));
}

// How far a line stays in the picture, at most "longest".
float RayInPicture(WaterRay ray, float longest)
{
    float4 within = ray.clipStart.w + float4(-ray.clipStart.xy, ray.clipStart.xy);
    float4 rates = float4(ray.clipStep.xy, -ray.clipStep.xy) - ray.clipStep.w;
    float4 exits = rates > 1e-6 ? max(within, 0.0) / max(rates, 1e-6) : (float4)longest;
    return min(min(min(exits.x, exits.y), min(exits.z, exits.w)), longest);
}

// 1 well within the picture, 0 at its border and beyond.
float PictureShare(float2 screen)
{
    float2 within = min(screen, 1.0 - screen) / PICTURE_MARGIN;
    return saturate(min(within.x, within.y));
}

struct MarchEnd
{
    float metres; // how far the line was followed
    bool isMet;   // whether the scene is met there; else it ends, or passes behind something
    bool isWhole; // whether it was followed to its end
};

// Share of a line's picture to metres. nearer: depth of its start to that of its end; 1 where all is as large. Worked example: of a line
// from 1 m to 3 m before the camera the middle of its picture is a quarter of its length.
float MarchMetres(float share, float longest, float nearer)
{
    return longest * share * nearer / (1.0 - share + share * nearer);
}

// Follows a line, in steps that are even on the screen, until the scene lies in front of it. Where the doubt between the last point before
// and the first behind shrinks as it is halved, they belong to one thing, which is met where its plane is. Where it does not, the line
// passes behind a thing's edge, and goes on where it is seen again, past a thing that is thin; where it is not, it ends at the last point
// that is seen. Worked example: gaps of 0.3 m and -0.1 m belong to a slope if four halvings leave a fall of 0.025 m, to an edge if they
// leave 0.37 m.
MarchEnd March(WaterRay ray, float longest, uint most)
{
    float last = max(RayDepth(ray, longest), 0.01 * ray.front);
    float nearer = unity_OrthoParams.w > 0.5 ? 1.0 : clamp(ray.front / last, 1e-3, 100.0);
    float pixels = length((RayScreen(ray, longest) - RayScreen(ray, 0.0)) * _FluidThicknessView.xy);
    uint steps = (uint)clamp(ceil(pixels / STEP_PIXELS), 1.0, (float)most);
    float seen = 0.0;
    float gapSeen = max(MarchGap(ray, 0.0), 0.0);
    bool isHidden = false;
    MarchEnd end;
    end.isMet = false;
    [loop]
    for (uint i = 1; i <= steps && !end.isMet; i++)
    {
        float behind = (float)i / (float)steps;
        float gapBehind = MarchGap(ray, MarchMetres(behind, longest, nearer));
        if (gapBehind >= 0.0)
        {
            seen = behind;
            gapSeen = gapBehind;
            isHidden = false;
        }
        else if (!isHidden)
        {
            float fall = gapSeen - gapBehind;
            float step = behind - seen;
            [loop]
            for (uint j = 0; j < MARCH_HALVINGS && (behind - seen) * pixels > 1.0; j++)
            {
                float middle = 0.5 * (seen + behind);
                float gap = MarchGap(ray, MarchMetres(middle, longest, nearer));
                if (gap < 0.0)
                {
                    behind = middle;
                    gapBehind = gap;
                }
                else
                {
                    seen = middle;
                    gapSeen = gap;
                }
            }
            float left = gapSeen - gapBehind;
            end.isMet = left < lerp((behind - seen) / step, 1.0, 0.35) * fall || left < 2e-3 * ray.front;
            isHidden = !end.isMet;
            if (end.isMet)
            {
                float before = PlaneGap(ray, MarchMetres(seen, longest, nearer));
                float after = PlaneGap(ray, MarchMetres(behind, longest, nearer));
                // A line that runs along a plane does not come nearer to it between the two.
                float met = before - after > 0.25 * left ? before / (before - after) : 0.5;
                seen = max(lerp(seen, behind, clamp(met, -8.0, 4.0)), 0.0);
            }
        }
    }
    end.isWhole = !end.isMet && !isHidden;
    if (isHidden)
        seen = max(seen - EDGE_PIXELS / max(pixels, 1e-3), 0.0);
    end.metres = MarchMetres(min(seen, 1.0), longest, nearer);
    return end;
}

#endif
