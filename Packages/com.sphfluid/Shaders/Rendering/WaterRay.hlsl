// A line of light followed through the picture of the scene's depth, to what is seen there.
#ifndef SPHFLUID_WATER_RAY_INCLUDED
#define SPHFLUID_WATER_RAY_INCLUDED

#include "WaterPath.hlsl"

#define MARCH_HALVINGS 4
#define EDGE_PIXELS 2.0
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

float3 RayPoint(WaterRay ray, float metres)
{
    return ray.start + ray.direction * metres;
}

float2 RayScreen(WaterRay ray, float metres)
{
    float4 clipPosition = ray.clipStart + ray.clipStep * metres;
    return clipPosition.xy / clipPosition.w * float2(0.5, 0.5 * _ProjectionParams.x) + 0.5;
}

// How far the scene lies behind a point of the line, metres along the camera's axis; negative: in front, by more than pixels and their
// depths are off: what stands at a wall, such as a tank's frame, is not in front of it.
float GapBehind(WaterRay ray, float metres)
{
    float depth = ray.front + ray.depthStep * metres;
    return NearestSceneDepth(RayScreen(ray, metres)) + DEPTH_DOUBT * depth - depth;
}

struct MarchEnd
{
    float metres; // how far the line was followed
    bool isMet;   // whether the scene is met there; else it ends, or passes behind something
    bool isWhole; // whether it was followed to its end
};

// Share of a line to metres. curve 0: even steps over "longest"; 1: even steps on the screen for a line to infinity, half of which is
// "longest".
float MarchMetres(float share, float longest, float curve)
{
    return longest * share / (1.0 - 0.99 * curve * share);
}

// Follows a line until the scene lies in front of it. Where the doubt between the last point before and the first behind shrinks as it is
// halved, they belong to one thing, which is met between them. Where it does not, the line passes behind a thing's edge, and goes on where
// it is seen again, past a thing that is thin; where it is not, it ends at the last point that is seen. Worked example: gaps of 0.3 m and
// -0.1 m belong to a slope if four halvings leave a fall of 0.025 m, to an edge if they leave 0.37 m.
MarchEnd March(WaterRay ray, float longest, float curve, uint steps)
{
    float seen = 0.0;
    float gapSeen = max(GapBehind(ray, 0.0), 0.0);
    bool isHidden = false;
    MarchEnd end;
    end.isMet = false;
    [loop]
    for (uint i = 1; i <= steps && !end.isMet; i++)
    {
        float behind = (float)i / (float)steps;
        float gapBehind = GapBehind(ray, MarchMetres(behind, longest, curve));
        if (gapBehind >= 0.0)
        {
            seen = behind;
            gapSeen = gapBehind;
            isHidden = false;
        }
        else if (!isHidden)
        {
            float fall = gapSeen - gapBehind;
            [loop]
            for (uint j = 0; j < MARCH_HALVINGS; j++)
            {
                float middle = 0.5 * (seen + behind);
                float gap = GapBehind(ray, MarchMetres(middle, longest, curve));
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
            end.isMet = left < 0.4 * fall || left < 2e-3 * ray.front;
            isHidden = !end.isMet;
            float doubt = DEPTH_DOUBT * (ray.front + ray.depthStep * MarchMetres(seen, longest, curve));
            float met = lerp(seen, behind, clamp((gapSeen - doubt) / max(left, 1e-6), -8.0, 1.0));
            seen = end.isMet ? max(met, 0.0) : seen;
        }
    }
    end.isWhole = !end.isMet && !isHidden;
    end.metres = MarchMetres(seen, longest, curve);
    if (isHidden)
    {
        // Pixels beside an edge have a share of what stands before it.
        float2 ahead = (RayScreen(ray, end.metres + 0.01 * longest) - RayScreen(ray, end.metres)) * _FluidThicknessView.xy;
        end.metres = max(end.metres - 0.01 * longest * EDGE_PIXELS / max(length(ahead), 1e-3), 0.0);
    }
    return end;
}

#endif
