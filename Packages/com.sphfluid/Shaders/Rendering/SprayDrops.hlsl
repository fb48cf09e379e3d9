// Particles without company as clusters of small drops, streaked by their motion while the shutter is open. The vertex stage expands them:
// six vertices a drop, no geometry shader. Everything follows from the particle's Id, so that nothing flickers.
#ifndef SPHFLUID_SPRAY_DROPS_INCLUDED
#define SPHFLUID_SPRAY_DROPS_INCLUDED

#include "../Surface/Sparse/SprayParticle.hlsl"
#include "WaterPath.hlsl"
#include "ReceivedShadow.hlsl"

StructuredBuffer<SprayParticle> _SprayParticles;
float _FluidSceneHeight; // pixels of the height of the picture of the scene, while drops are drawn into it
uint _DropsPerParticle;
float _SprayShutter;  // how long the shutter is open [s]
float _SpraySpacing;  // dx [m]
float4 _SprayColor;   // rgb: in white light
float4 _SprayGlow;    // rgb: light that it gives off

#define MIST_COVER 0.04
#define DROP_COVER 0.95
#define AGAINST_THE_LIGHT 0.5
#define TRAIL 0.012 // the drops of a particle leave its place within so long [s]
#define LEAST_RADIUS 0.9 // pixels; smaller drops cover less instead

struct DropFragment
{
    float4 clipPosition : SV_Position;
    float3 across : TEXCOORD0; // xy: from the middle, in radii; z: half the length of the streak, in radii
    float3 world : TEXCOORD1;
    float4 colour : TEXCOORD2; // premultiplied
    nointerpolation float softness : TEXCOORD3; // of mist: how far before a surface it begins to fade [m]; of drops 0
    EYE_FIELD
};

// PCG (Jarzynski and Olano 2020, "Hash functions for GPU rendering"): three numbers from 0 to 1, of two.
float3 HashOf(uint id, uint k)
{
    uint3 v = uint3(id, k, id ^ (k * 747796405u)) * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return (float3)(v >> 8) / 16777216.0;
}

// A point of the unit ball, evenly spread.
float3 InBall(float3 random)
{
    float height = 2.0 * random.x - 1.0;
    float angle = 6.2831853 * random.y;
    float flat = sqrt(saturate(1.0 - height * height));
    return float3(flat * cos(angle), height, flat * sin(angle)) * pow(random.z, 1.0 / 3.0);
}

// Corners of two triangles: (-1,-1) (-1,1) (1,1) and (-1,-1) (1,1) (1,-1).
float2 DropCorner(uint index)
{
    float x = index == 2 || index == 4 || index == 5 ? 1.0 : -1.0;
    float y = index == 1 || index == 2 || index == 4 ? 1.0 : -1.0;
    return float2(x, y);
}

// Drops let light through: the side to the sun is the brighter one, and against it they shine.
float3 DropLight(float3 normal, float3 view, float sun)
{
    float3 light = _FluidLightDirection.xyz;
    float against = saturate(-dot(view, light));
    against *= against;
    return FluidLampColour() * (sun * (0.5 + 0.5 * dot(normal, light) + AGAINST_THE_LIGHT * against * against)) + FluidAmbient(normal);
}

DropFragment ExpandDropFor(uint vertexId, float height)
{
    uint drop = vertexId / 6u;
    uint k = drop % _DropsPerParticle;
    SprayParticle particle = _SprayParticles[drop / _DropsPerParticle];
    float3 place = HashOf(particle.id, 2u * k);
    float3 size = HashOf(particle.id, 2u * k + 1u);
    float3 spread = InBall(size.yzx);

    // The first of a particle is a puff of mist, the others appear one by one as the particle leaves the surface.
    bool isMist = k == 0u;
    float rank = ((float)k - size.y) / (float)_DropsPerParticle;
    float grown = isMist ? particle.spray : saturate((particle.spray - rank) * 5.0);
    float radius = _SpraySpacing * (isMist ? 1.5 : lerp(0.02, 0.14, size.x * size.x * size.x * size.x)) * grown;
    float3 apart = InBall(place) * (_SpraySpacing * (0.35 + particle.spray)) +
        particle.velocity * ((size.z - 0.5) * TRAIL * particle.spray);
    float3 centre = particle.position + (isMist ? (float3)0.0 : apart);
    float3 streak = (particle.velocity + 0.25 * length(particle.velocity) * spread) * (isMist ? 0.0 : _SprayShutter);

    DropFragment output;
    EYE_TO(output)
    float3 world = FluidWorldPosition(centre);
    float3 axis = FluidWorldDirection(streak);
    float3 right = unity_MatrixV[0].xyz;
    float3 up = unity_MatrixV[1].xyz;
    float2 seen = float2(dot(axis, right), dot(axis, up));
    float halfLength = 0.5 * length(seen);
    float2 along = halfLength > 1e-7 ? seen / (2.0 * halfLength) : float2(1.0, 0.0);
    float drawn = max(radius, LEAST_RADIUS * FluidPixelWidth(world, height));
    float cover = (isMist ? MIST_COVER : DROP_COVER / sqrt(1.0 + halfLength / drawn)) * (radius / drawn) * (isMist ? 1.0 : radius / drawn);

    float2 corner = DropCorner(vertexId % 6u) * float2(halfLength / drawn + 1.0, 1.0);
    float2 offset = (along * corner.x + float2(-along.y, along.x) * corner.y) * (grown > 0.0 ? drawn : 0.0);
    float3 aside = right * offset.x + up * offset.y;
    output.world = world + aside;
    output.across = float3(corner, halfLength / drawn);
    output.clipPosition = FluidClipOfLocal(centre, aside);
    output.softness = isMist ? drawn : 0.0;
    float3 view = WaterView(world);
    float2 side = DropCorner(vertexId % 6u);
    side = along * side.x + float2(-along.y, along.x) * side.y;
    float sun = ReceivedSun(world, 0.0, SURFACE_LIFT, _FluidReceived.z);
    float3 light = DropLight(normalize(view + right * side.x + up * side.y), view, sun);
    output.colour = float4(FluidExposed(_SprayColor.rgb * light + _SprayGlow.rgb) * cover, cover);
    return output;
}

DropFragment ExpandDrop(uint vertexId : SV_VertexID EYE_PARAMETER)
{
    EYE_OF_INSTANCE
    return ExpandDropFor(vertexId, _FluidThicknessView.y);
}

DropFragment ExpandDropBehindWater(uint vertexId : SV_VertexID EYE_PARAMETER)
{
    EYE_OF_INSTANCE
    return ExpandDropFor(vertexId, _FluidSceneHeight);
}

// A capsule, densest along its middle. gap: to the surface behind or before it, metres along the camera's axis.
float4 ShadeDrop(DropFragment input, float gap)
{
    float2 beyond = float2(max(abs(input.across.x) - input.across.z, 0.0), input.across.y);
    float rest = saturate(1.0 - dot(beyond, beyond));
    float soft = input.softness > 0.0 ? saturate(gap / input.softness) : 1.0;
    return input.colour * (rest * rest * soft);
}

float4 ShadeDropBeforeWater(DropFragment input) : SV_Target
{
    EYE_OF(input)
    float2 screen = WaterScreen(input.world);
    float depth = WaterEyeDepth(input.world);
    clip(IsBeyondSurfaceFromWithin(screen, depth) ? -1.0 : 1.0);
    float gap = 0.0;
    [branch]
    if (input.softness > 0.0)
        gap = min(SceneEyeDepth(screen), NearestWater(screen)) - depth;
    return ShadeDrop(input, gap);
}

// Into the picture of the scene that the water refracts, tested here as it has no depth of its own size: nothing behind the scene, nothing
// before the water.
float4 ShadeDropBehindWater(DropFragment input) : SV_Target
{
    EYE_OF(input)
    float2 screen = WaterScreen(input.world);
    float depth = WaterEyeDepth(input.world);
    float gap = min(SceneEyeDepth(screen) - depth, depth - FirstLayerEnd(screen));
    clip(gap);
    return ShadeDrop(input, gap);
}

#endif
