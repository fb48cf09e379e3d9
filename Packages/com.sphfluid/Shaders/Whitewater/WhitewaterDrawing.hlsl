// Whitewater as soft spots, one triangle each: streaked drops that face the camera, flakes of foam that lie on the surface, small bubbles.
// One colour, premultiplied: their order does not matter. Everything follows from a piece's own numbers, so that nothing flickers.
#ifndef SPHFLUID_WHITEWATER_DRAWING_INCLUDED
#define SPHFLUID_WHITEWATER_DRAWING_INCLUDED

#include "WhitewaterTypes.hlsl"
#include "WhitewaterHash.hlsl"
#include "FoamPattern.hlsl"
#include "../Rendering/WaterPath.hlsl"
#include "../Rendering/ReceivedShadow.hlsl"

StructuredBuffer<WhitewaterParticle> _Whitewater;
float4 _ScreenParams;       // y: pixels of the picture's height
float _FluidSceneHeight;    // of the picture of the scene, while pieces are drawn into it
float4 _Color;              // linear
float _WhitewaterSpacing;   // dx [m]
float _WhitewaterSize;      // 1 by default
float _WhitewaterShutter;   // s
float _WhitewaterPhase;     // of the pattern of foam, in its periods

#define LEAST_RADIUS 1.0   // pixels; smaller spots cover less instead
#define SHADOW_LIFT 1.0    // dx: how far before the bumpy surface shadows are taken
#define LIFT 0.7           // dx: how far foam is lifted towards the camera, as the surface is bumpy
#define FACING 0.35        // how much flakes turn towards the camera: foam has a thickness
#define FADE_IN 0.04       // s
#define FADE_OUT 1.2       // s
#define FOAM_CELL 0.33     // dx: a cell of the film that flakes are parts of
#define BUBBLE_GAP 4.0     // dx: bubbles nearer to what is behind them are fainter
#define LEAST_COVER 0.004  // of a spot that is drawn: a step of 8 bits

struct SpotFragment
{
    float4 clipPosition : SV_Position;
    float3 across : TEXCOORD0; // xy: from the middle, in radii; z: kind
    float3 world : TEXCOORD1;
    nointerpolation float4 colour : TEXCOORD2; // premultiplied
    float4 film : TEXCOORD3; // of foam: where in the two patterns, in cells
    nointerpolation float contrast : TEXCOORD4;
    EYE_FIELD
};

// Corners of a triangle around the unit circle.
float2 SpotCorner(uint index)
{
    return index == 0u ? float2(0.0, 2.0) : float2(index == 1u ? 1.7320508 : -1.7320508, -1.0);
}

// How much of a piece belongs into the picture of the scene that water refracts: nothing behind the scene, and of what is not within the
// water nothing before it. Bubbles fade before what they float close to: on it they would be spots of its own.
float SeenThroughWater(float3 world, uint kind)
{
    float2 screen = WaterScreen(world);
    float depth = WaterEyeDepth(world);
    float before = SceneEyeDepth(screen) - depth;
    float free = saturate(before / (BUBBLE_GAP * _WhitewaterSpacing));
    float others = before > 0.0 && depth > FirstLayerEnd(screen) ? 1.0 : 0.0;
    return kind == WHITEWATER_BUBBLE ? free * free : others;
}

// Foam lies on the surface, and is seen from below as it lies.
float SeenBeforeWater(float3 world, uint kind)
{
    return kind == WHITEWATER_FOAM || !IsBeyondSurfaceFromWithin(WaterScreen(world), WaterEyeDepth(world)) ? 1.0 : 0.0;
}

SpotFragment ExpandSpot(uint vertexId, bool behind)
{
    WhitewaterParticle piece = _Whitewater[vertexId / 3u];
    uint kind = KindOf(piece);
    float3 random = HashUnit(uint3(piece.seed >> 2u, 7u, 11u));
    float3 turn = HashUnit(uint3(piece.seed >> 2u, 13u, 17u));
    float3 world = FluidWorldPosition(piece.position);
    float3 view = WaterView(world);
    float3 right = unity_MatrixV[0].xyz;
    float3 up = unity_MatrixV[1].xyz;
    float3 normal = view;
    float fade = saturate(piece.age / FADE_IN) * saturate(piece.life / FADE_OUT);
    float radius = 0.0;
    float cover = 0.0;
    float stretch = 1.0;

    if (kind == WHITEWATER_SPRAY)
    {
        radius = lerp(0.03, 0.16, random.x * random.x * random.x);
        cover = 0.8;
    }
    if (kind == WHITEWATER_FOAM)
    {
        radius = lerp(0.25, 0.75, random.x * random.x);
        cover = 0.55;
        normal = normalize(FluidWorldDirection(piece.normal) + view * FACING + 1e-6);
    }
    if (kind == WHITEWATER_BUBBLE && behind)
    {
        radius = lerp(0.06, 0.25, random.x * random.x);
        cover = 0.3;
    }
    radius *= _WhitewaterSpacing * _WhitewaterSize;

    float pixel = FluidPixelWidth(world, behind ? _FluidSceneHeight : _ScreenParams.y);
    float drawn = max(radius, LEAST_RADIUS * pixel);
    float2 axis = float2(cos(6.2831853 * turn.x), sin(6.2831853 * turn.x));
    float3 along = normalize(abs(normal.y) < 0.9 ? cross(normal, float3(0.0, 1.0, 0.0)) : cross(normal, float3(1.0, 0.0, 0.0)));
    float3 across = cross(normal, along);
    if (kind != WHITEWATER_FOAM)
    {
        along = right;
        across = up;
    }
    if (kind == WHITEWATER_SPRAY)
    {
        float3 streak = FluidWorldDirection(piece.velocity) * _WhitewaterShutter;
        float2 seen = float2(dot(streak, right), dot(streak, up));
        float reach = length(seen);
        axis = reach > 1e-7 ? seen / reach : axis;
        stretch = 1.0 + 0.5 * reach / drawn;
    }
    cover *= fade * (radius / drawn) * (radius / drawn) / sqrt(stretch);
    cover *= behind ? SeenThroughWater(world, kind) : SeenBeforeWater(world, kind);

    SpotFragment output;
    EYE_TO(output)
    float2 corner = SpotCorner(vertexId % 3u);
    float2 offset = (axis * (corner.x * stretch) + float2(-axis.y, axis.x) * corner.y) * (cover > LEAST_COVER ? drawn : 0.0);
    float3 aside = along * offset.x + across * offset.y;
    output.world = world + aside;
    float3 lift = kind == WHITEWATER_FOAM ? WaterView(output.world) * (LIFT * _WhitewaterSpacing) : (float3)0.0;
    output.across = float3(corner, (float)kind);
    output.clipPosition = FluidClipOfLocal(piece.position, aside + lift);
    float3 lit = normalize((kind == WHITEWATER_FOAM ? normal : (float3)0.0) + float3(0.0, 1.0, 0.0));
    float sun = ReceivedSun(world, 0.0, SHADOW_LIFT, _FluidReceived.z);
    output.colour = float4(FluidExposed(FluidDiffuse(_Color.rgb, lit, sun)) * cover, cover);
    float cell = FOAM_CELL * _WhitewaterSpacing * _WhitewaterSize;
    output.film = FilmPlaces(FluidLocalPosition(output.world), piece.velocity, piece.normal, _WhitewaterPhase, cell);
    output.contrast = saturate(1.5 - 1.5 * pixel / cell);
    return output;
}

float4 ShadeSpot(SpotFragment input) : SV_Target
{
    float rest = saturate(1.0 - dot(input.across.xy, input.across.xy));
    float density = rest * rest;
    // Of a flake's edge only the rims of cells are left, so that it has no outline of its own.
    [branch]
    if (abs(input.across.z - (float)WHITEWATER_FOAM) < 0.5)
        density = saturate(1.6 * rest - 1.4 * (1.0 - FilmAt(input.film, _WhitewaterPhase, input.contrast)));
    return input.colour * density;
}

SpotFragment ExpandFrontSpot(uint vertexId : SV_VertexID EYE_PARAMETER)
{
    EYE_OF_INSTANCE
    return ExpandSpot(vertexId, false);
}

SpotFragment ExpandSpotBehindWater(uint vertexId : SV_VertexID EYE_PARAMETER)
{
    EYE_OF_INSTANCE
    return ExpandSpot(vertexId, true);
}

#endif
