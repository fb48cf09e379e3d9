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
#define WALL_CONTACT 0.03 // metres; a scene so near behind a wall is the wall, which mirrors nothing

struct SeenThrough
{
    float2 screen; // where the scene's colour is
    float path;    // way through water, metres
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

// How far a line runs in the nearest layer, whose faces are known along lines of sight: ever longer steps go on while they stay in it, the
// last one is halved, and the layer's far face there ends the line. Without steps, and where the layer has no far face, it is as long as
// "straight".
float LayerLength(WaterRay ray, float straight, float toWall)
{
    uint tries = (uint)_FluidRefractionSteps.x / 3u;
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
    // Where the face crosses the line, by the last two points; by the first and the last before where the other is hidden or not in sight.
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
    ended = FirstLayerEnd(RayScreen(ray, within)) < 0.0 ? straight : max(ended, 0.0);
    bool isOpen = FirstLayerEnd(RayScreen(ray, 0.0)) < 0.0;
    return tries == 0u || isOpen ? min(straight, toWall) : reachesWall ? toWall : ended;
}

// Light leaves the layer and goes on as it came: parallel faces, those of a tank's panes for example, turn it back into its old direction.
float2 SeenBehindLayer(WaterRay ray, float metres, float3 view, float2 screen)
{
    WaterRay onward = StartRay(RayPoint(ray, metres), -view);
    float2 place = onward.front > _ProjectionParams.y ? RayScreen(onward, 0.0) : screen;
    if (_FluidRefractionSteps.y > 0.5)
    {
        MarchEnd end = March(onward, FAR_BEHIND * onward.front / max(onward.depthStep, 1e-3), (uint)_FluidRefractionSteps.y);
        place = end.isWhole ? screen : RayScreen(onward, end.metres);
    }
    return place;
}

// A pane at the side of a tank mirrors what meets it at less than the critical angle: sin of the angle to the normal above 0.75. On a film,
// up to two spacings thick, the particles' bumps would show all that stands round the tank in pieces.
bool IsMirroredByWall(WaterRay ray, float longest, DomainExit exit)
{
    float across = dot(ray.direction, exit.normal);
    bool reaches = exit.metres - longest < 2.0 * _MCCellSize.x;
    float3 inwards = RayPoint(ray, longest) - exit.normal * (2.0 * _FluidReceived.y + _MCCellSize.x);
    return reaches && _FluidRefractionSteps.z > 0.5 && 1.0 - across * across > AIR_TO_WATER * AIR_TO_WATER &&
        GapBehind(ray, longest) > WALL_CONTACT && IsInLayer(WaterScreen(inwards), WaterEyeDepth(inwards));
}

// What is seen along a line of sight that meets the water at "world".
// layer: thickness of the nearest layer; water: of all of it before the scene; both metres along the camera's axis.
SeenThrough SeeThrough(float3 world, float3 view, float3 normal, float alongAxis, float layer, float water)
{
    SeenThrough seen;
    float2 screen = WaterScreen(world);
    float3 bent = normalize(lerp(-view, refract(-view, normal, AIR_TO_WATER), _Refraction));
    WaterRay ray = StartRay(world, bent);
    DomainExit exit = LeaveDomain(world, bent);
    float longest = LayerLength(ray, layer / alongAxis, exit.metres);
    float others = max(water - layer, 0.0) / alongAxis;

    MarchEnd end;
    if (_FluidRefractionSteps.x > 0.5)
    {
        end = March(ray, longest, (uint)_FluidRefractionSteps.x);
    }
    else
    {
        end.isMet = false;
        end.isWhole = GapBehind(ray, longest) >= 0.0;
        end.metres = end.isWhole ? longest : 0.0;
    }
    seen.screen = RayScreen(ray, end.metres);
    seen.path = end.isMet ? end.metres : end.isWhole ? longest + others : water / alongAxis;
    if (end.isWhole)
    {
        if (IsMirroredByWall(ray, longest, exit))
        {
            WaterRay mirrored = StartRay(RayPoint(ray, longest), reflect(bent, exit.normal));
            float reach = LeaveDomain(mirrored.start, mirrored.direction).metres;
            MarchEnd second = March(mirrored, reach, (uint)_FluidRefractionSteps.x);
            seen.screen = RayScreen(mirrored, second.metres);
            seen.path = longest + min(second.metres, LayerLength(mirrored, 0.0, reach));
        }
        else if (GapBehind(ray, longest) > 2e-3 * ray.front)
        {
            seen.screen = SeenBehindLayer(ray, longest, view, screen);
        }
    }
    return seen;
}

#endif
