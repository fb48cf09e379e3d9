#ifndef SPHFLUID_WALL_PATCHES
#define SPHFLUID_WALL_PATCHES

// The force of the liquid on rectangles of its walls: a kernel that changes a velocity at a wall calls GiveToPatches with the change. It is
// spread over the wall within a spacing of the particle's foot, up to where the wall ends, and each rectangle sums what of the opposite
// impulse lies on it, in whole units: the same in any order. A kernel that includes
// this file declares "#pragma multi_compile_local _ FLUID_WALL_FORCES", includes FluidCounters.hlsl and DomainFaces.hlsl, and is bound by
// WallForces.Set.

// As PlaceWallPatches leaves them for a step. Mirrored by PlacedPatch in WallForces.cs; 80 bytes.
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
    float4 Ends;   // m: from the centre to the wall's ends along -Right, Right, -Up, Up
};

#if defined(FLUID_WALL_FORCES)

#define PATCH_LEAST_FACING 0.5 // cosine between a wall's normal and the rectangle's
#define PATCH_LEAST_AT_END -0.7 // where the wall ends: round its edge its faces hold particles together
#define PATCH_END_TOLERANCE 0.05 // of the reach

StructuredBuffer<WallPatch> _WallPatches;
RWStructuredBuffer<uint> _WallSums; // low and high word
float _PatchUnits;   // a m/s: those that a change of a particle's velocity by 1 m/s is worth
float _PatchReach; // m: so far about a particle's foot its force is spread

static const float PATCH_MOST_UNITS = 2147483520.0; // the largest float below 2^31

// Integral of (1 - t^2)^2 from 0, which is 0 beyond 1.
float4 Spread(float4 t)
{
    const float4 u = clamp(t, -1.0, 1.0);
    const float4 square = u * u;
    return u * (1.0 - square * (2.0 / 3.0 - 0.2 * square));
}

// Parts, along two axes, of what is spread about x over a wall from low to high that lie in [-half, half].
float2 PartWithin(float2 x, float2 halfLength, float2 low, float2 high)
{
    const float4 wall = Spread(float4(high - x, low - x));
    const float4 own = Spread(float4(min(high, halfLength) - x, max(low, -halfLength) - x));
    return max(own.xy - own.zw, 0.0) / (wall.xy - wall.zw);
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
        const float scale = 1.0 / _PatchReach;
        const float2 low = -scale * patch.Ends.xz;
        const float2 high = scale * patch.Ends.yw;
        const float2 at = scale * float2(dot(d, patch.Right), dot(d, patch.Up));
        const float beyond = max(max(at.x - high.x, low.x - at.x), max(at.y - high.y, low.y - at.y));
        const float2 part = PartWithin(clamp(at, low, high), scale * float2(patch.HalfX, patch.HalfY), low, high);
        const float share = part.x * part.y;
        [branch]
        if (share > 0.0 && dot(normal, n) > (beyond > -PATCH_END_TOLERANCE ? PATCH_LEAST_AT_END : PATCH_LEAST_FACING) && beyond < 1.0 &&
            abs(dot(d, n)) < patch.Depth)
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
