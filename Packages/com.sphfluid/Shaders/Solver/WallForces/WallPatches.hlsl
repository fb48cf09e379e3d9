#ifndef SPHFLUID_WALL_PATCHES
#define SPHFLUID_WALL_PATCHES

// The force of the liquid on rectangles of its walls: a kernel that changes a velocity at a wall calls GiveToPatches with the change, and
// each rectangle that the wall's point lies on sums the opposite impulse, in whole units: the same in any order. A kernel that includes
// this file declares "#pragma multi_compile_local _ FLUID_WALL_FORCES", includes FluidCounters.hlsl and DomainFaces.hlsl, and is bound by
// WallForces.Set.

// As PlaceWallPatches leaves them for a step. Mirrored by PlacedPatch in WallForces.cs; 64 bytes.
struct WallPatch
{
    float3 Centre; // m
    float HalfX;   // m, along Right
    float3 Right;
    float HalfY;   // m, along Up
    float3 Up;     // Right x Up is the normal, towards the liquid
    float Depth;   // m: walls so far before or behind the rectangle belong to it
    uint Count;    // of the rectangles, the same in each
    uint Sum;      // where the words of its sum of this step are
    uint2 Unused;
};

#if defined(FLUID_WALL_FORCES)

#define PATCH_LEAST_FACING 0.5 // cosine between a wall's normal and the rectangle's

StructuredBuffer<WallPatch> _WallPatches;
RWStructuredBuffer<uint> _WallSums; // low and high word
float _PatchUnits;   // a m/s: those that a change of a particle's velocity by 1 m/s is worth
float _PatchSpacing; // m: a particle stands on a square of this edge

static const float PATCH_MOST_UNITS = 2147483520.0; // the largest float below 2^31

// Part of an interval of length 1 about x that lies in [-half, half].
float2 PartWithin(float2 x, float2 halfLength)
{
    return saturate(min(x + 0.5, halfLength) - max(x - 0.5, -halfLength));
}

// foot: the wall's point that is nearest to the particle; normal: of the wall there, towards the particle; change: of its velocity.
void GiveToPatches(float3 foot, float3 normal, float3 change)
{
    const uint count = _WallPatches[0].Count;
    [loop]
    for (uint p = 0u; p < count; p++)
    {
        const WallPatch patch = _WallPatches[p];
        const float3 n = cross(patch.Right, patch.Up);
        const float3 d = Separation(foot, patch.Centre);
        const float2 scale = 1.0 / _PatchSpacing;
        const float2 part = PartWithin(float2(dot(d, patch.Right), dot(d, patch.Up)) * scale, float2(patch.HalfX, patch.HalfY) * scale);
        const float share = part.x * part.y;
        [branch]
        if (share > 0.0 && dot(normal, n) > PATCH_LEAST_FACING && abs(dot(d, n)) < patch.Depth)
        {
            const float exact = share * dot(change, n) * _PatchUnits;
            if (!(abs(exact) <= PATCH_MOST_UNITS)) // or no number
            {
                CountEvent(COUNTER_IMPULSE_LIMIT);
            }
            const int units = int(round(clamp(IsFinite(float3(exact, 0.0, 0.0)) ? exact : 0.0, -PATCH_MOST_UNITS, PATCH_MOST_UNITS)));
            uint was;
            InterlockedAdd(_WallSums[patch.Sum], uint(units), was);
            const uint carry = was + uint(units) < was ? 1u : 0u;
            InterlockedAdd(_WallSums[patch.Sum + 1u], (units < 0 ? 0xffffffffu : 0u) + carry);
        }
    }
}

#endif

#endif
