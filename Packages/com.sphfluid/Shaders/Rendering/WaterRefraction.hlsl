// What is seen through the water: light is bent at the surface, runs through the nearest layer, and goes on as it came, or is mirrored by a
// wall.
#ifndef SPHFLUID_WATER_REFRACTION_INCLUDED
#define SPHFLUID_WATER_REFRACTION_INCLUDED

#include "WaterRay.hlsl"
#include "ReceivedShadow.hlsl"

float _Refraction;           // 1: as much as in nature
float4 _FluidRefractionSteps; // most steps, 0: none. x: through the water; y: behind it; w: of what is mirrored; z: 1 if walls mirror

#define AIR_TO_WATER 0.75 // ratio of the refractive indices, 1 / 1.33
#define FAR_BEHIND 50.0    // times as far as the camera
#define NOT_IN_PICTURE -1.0
#define WALL_CONTACT 0.03 // metres; a scene so near behind a wall is the wall, which mirrors nothing

struct SeenThrough
{
    float2 screen; // where the scene's colour is
    float path;    // way through water, metres
    float2 mirror; // where the colour is that the surface mirrors, or NOT_IN_PICTURE
};

// Where a line leaves the domain: distance, and the wall's outward normal in world space.
struct DomainExit
{
    float metres;
    float3 normal;
};

DomainExit LeaveDomain(float3 world, float3 direction)
{
    float3 position = FluidLocalPosition(world);
    float3 ahead = FluidLocalDirection(direction);
    float3 reciprocal = 1.0 / (abs(ahead) > 1e-6 ? ahead : (float3)1e-6);
    float3 lower = (_MCMinimum - position) * reciprocal;
    float3 upper = (_MCMinimum + _MCCells * _MCCellSize - position) * reciprocal;
    float3 exits = max(max(lower, upper), 0.0);
    DomainExit exit;
    exit.metres = min(exits.x, min(exits.y, exits.z));
    float3 isWall = float3(exits.x <= exit.metres ? 1.0 : 0.0, 0.0, 0.0);
    if (exits.x > exit.metres)
        isWall = exits.y <= exit.metres ? float3(0.0, 1.0, 0.0) : float3(0.0, 0.0, 1.0);
    exit.normal = FluidWorldDirection(isWall * sign(ahead));
    return exit;
}

// Whether a point lies in the nearest layer as lines of sight have it; a little beside it counts as well.
bool IsInLayer(float2 screen, float depth)
{
    float2 span = FirstLayerSpan(screen) + float2(-0.5, 0.5) * _MCCellSize.x;
    return all(screen == saturate(screen)) && depth > span.x && depth < span.y;
}

bool IsInLayer(WaterRay ray, float metres)
{
    return IsInLayer(RayScreen(ray, metres), RayDepth(ray, metres));
}

// How far the nearest layer goes on behind a point of a line, metres along the camera's axis.
float LayerLeft(WaterRay ray, float metres)
{
    return SmoothFirstLayerEnd(RayScreen(ray, metres)) - RayDepth(ray, metres);
}

// Where the layer's far face crosses a line, by its last point within and its first beyond; by the first and the last within where the
// other is hidden or not in sight.
float LayerEnd(WaterRay ray, float within, float beyond, float toWall)
{
    float2 last = RayScreen(ray, beyond);
    bool isInPicture = all(last == saturate(last));
    float before = LayerLeft(ray, within);
    float after = LayerLeft(ray, beyond);
    float ended = min(within + before / max(ray.depthStep, 1e-3), beyond);
    if (isInPicture && after < min(before, 0.0))
    {
        ended = lerp(within, beyond, clamp(before / (before - after), -8.0, 1.0));
    }
    else if (within > 0.0)
    {
        float first = LayerLeft(ray, 0.0);
        ended = first > before ? within * first / (first - before) : beyond;
        ended = clamp(ended, 0.0, isInPicture ? beyond : toWall);
    }
    return max(ended, 0.0);
}

// How far a line runs in the nearest layer, whose faces are known along lines of sight: ever longer steps go on while they stay in it, the
// last one is halved, and the layer's far face there ends the line. Without steps, and where the layer has no far face, it is as long as
// "straight".
float LayerLength(WaterRay ray, float straight, float toWall)
{
    uint tries = (uint)_FluidRefractionSteps.x / 3u;
    float ended = min(straight, toWall);
    [branch]
    if (tries > 0u && FirstLayerEnd(RayScreen(ray, 0.0)) >= 0.0)
    {
        float within = 0.0;
        float beyond = toWall;
        float metres = max(straight, _MCCellSize.x);
        [loop]
        for (uint i = 0; i < tries + 2u && metres < toWall; i++)
        {
            if (!IsInLayer(ray, metres))
            {
                beyond = metres;
                break;
            }
            within = metres;
            metres *= 2.0;
        }
        bool reachesWall = beyond >= toWall && IsInLayer(ray, toWall);
        [loop]
        for (uint j = 0; j < tries && !reachesWall; j++)
        {
            float middle = 0.5 * (within + beyond);
            if (IsInLayer(ray, middle))
                within = middle;
            else
                beyond = middle;
        }
        ended = toWall;
        [branch]
        if (!reachesWall)
            ended = FirstLayerEnd(RayScreen(ray, within)) < 0.0 ? straight : LayerEnd(ray, within, beyond, toWall);
    }
    return ended;
}

// A pane at the side of a tank mirrors what meets it at less than the critical angle: sin of the angle to the normal above 0.75. On a film,
// up to two spacings thick, the particles' bumps would show all that stands round the tank in pieces.
bool IsMirroredByWall(float3 end, float3 direction, float toWall, float3 wall)
{
    float across = dot(direction, wall);
    bool reaches = toWall < 2.0 * _MCCellSize.x;
    float3 inwards = end - wall * (2.0 * _FluidReceived.y + _MCCellSize.x);
    return reaches && _FluidRefractionSteps.z > 0.5 && 1.0 - across * across > AIR_TO_WATER * AIR_TO_WATER &&
        IsInLayer(WaterScreen(inwards), WaterEyeDepth(inwards));
}

// Lines that are followed one after the other, by one loop: inlined for each, the march would be most of the shader.
#define LINE_IN_WATER 0u
#define LINE_OFF_WALL 1u // mirrored by a wall
#define LINE_BEHIND 2u   // light leaves the layer and goes on as it came: parallel faces, as those of panes, turn it back
#define LINE_MIRRORED 3u // by the surface
#define LINE_NONE 4u

// wall, metres: where the line in water ended, which comes first.
WaterRay StartLine(uint kind, float3 world, float3 view, float3 normal, float3 wall, float metres)
{
    float3 bent = normalize(lerp(-view, refract(-view, normal, AIR_TO_WATER), _Refraction));
    float3 start = kind == LINE_OFF_WALL || kind == LINE_BEHIND ? world + bent * metres : world;
    float3 direction = kind == LINE_IN_WATER ? bent : -view;
    if (kind == LINE_OFF_WALL)
        direction = reflect(bent, wall);
    else if (kind == LINE_MIRRORED)
        direction = reflect(-view, normal);
    return StartRay(start, direction);
}

// Without steps a line is seen at its end, or where it starts if the scene hides that.
MarchEnd Follow(WaterRay ray, float longest, uint most)
{
    MarchEnd end;
    [branch]
    if (most > 0u)
    {
        end = March(ray, longest, most);
    }
    else
    {
        end.isMet = false;
        end.isWhole = GapBehind(ray, longest) >= 0.0;
        end.metres = end.isWhole ? longest : 0.0;
    }
    return end;
}

// What is seen along a line of sight that meets the water at "world". mirrors: whether what the surface mirrors is looked for in the
// picture. Each line is made from nothing but these and the first one's end, so that few registers stay in use while it is followed.
SeenThrough SeeThrough(float3 world, float3 view, float3 normal, bool mirrors)
{
    SeenThrough seen;
    seen.screen = 0.0;
    seen.path = 0.0;
    seen.mirror = NOT_IN_PICTURE;
    float longest = 0.0;
    float3 wall = 0.0; // its normal, where the line in water ends
    uint kind = LINE_IN_WATER;
    [loop]
    for (uint i = 0; i < 3u && kind != LINE_NONE; i++)
    {
        WaterRay ray = StartLine(kind, world, view, normal, wall, longest);
        float inLayer = 0.0;
        float others = 0.0; // metres of water in further layers
        uint onward = LINE_NONE;
        uint most = (uint)_FluidRefractionSteps.x;
        [branch]
        if (kind <= LINE_OFF_WALL)
        {
            float straight = 0.0;
            if (kind == LINE_IN_WATER)
            {
                float alongAxis = dot(view, unity_MatrixV[2].xyz);
                float all = WaterBehind(world, view, alongAxis);
                seen.screen = WaterScreen(world);
                seen.path = clamp(SceneEyeDepth(seen.screen) - ray.front, 0.0, all) / alongAxis;
                straight = min(FirstLayer(seen.screen, ray.front), all) / alongAxis;
            }
            DomainExit exit = LeaveDomain(ray.start, ray.direction);
            wall = exit.normal;
            longest = exit.metres;
            inLayer = LayerLength(ray, straight, longest);
            if (kind == LINE_IN_WATER)
            {
                longest = inLayer;
                float gap = GapBehind(ray, longest);
                float3 last = world + ray.direction * longest;
                if (gap > WALL_CONTACT && IsMirroredByWall(last, ray.direction, exit.metres - longest, wall))
                    onward = LINE_OFF_WALL;
                else if (gap > 2e-3 * ray.front)
                    onward = LINE_BEHIND;
                others = onward == LINE_OFF_WALL ? 0.0 : max(seen.path - straight, 0.0);
            }
        }
        else if (kind == LINE_BEHIND)
        {
            longest = FAR_BEHIND * ray.front / max(ray.depthStep, 1e-3);
            most = (uint)_FluidRefractionSteps.y;
        }
        else
        {
            float deep = ray.depthStep > 0.0 ? 0.9 * _ProjectionParams.z - ray.front : 0.9 * ray.front;
            longest = RayInPicture(ray, max(deep, 0.0) / max(abs(ray.depthStep), 1e-3));
            most = (uint)_FluidRefractionSteps.w;
        }
        MarchEnd end = Follow(ray, longest, most);
        float2 place = RayScreen(ray, end.metres);

        uint next = mirrors && kind != LINE_MIRRORED ? LINE_MIRRORED : LINE_NONE;
        if (kind == LINE_IN_WATER)
        {
            seen.screen = place;
            seen.path = end.isMet ? end.metres : end.isWhole ? longest + others : seen.path;
            next = end.isWhole && onward != LINE_NONE ? onward : next;
        }
        else if (kind == LINE_OFF_WALL)
        {
            seen.screen = place;
            seen.path += min(end.metres, inLayer);
        }
        else if (kind == LINE_BEHIND)
        {
            float2 screen = WaterScreen(world);
            float2 onward = ray.front > _ProjectionParams.y ? RayScreen(ray, 0.0) : screen;
            seen.screen = most == 0u ? onward : end.isWhole ? screen : place;
        }
        else if (end.isMet)
        {
            seen.mirror = place;
        }
        kind = next;
    }
    return seen;
}

#endif
