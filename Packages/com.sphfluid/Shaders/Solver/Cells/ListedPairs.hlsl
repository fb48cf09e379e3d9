#ifndef SPHFLUID_LISTED_PAIRS
#define SPHFLUID_LISTED_PAIRS

// Sums over the pairs that an earlier pass listed, at the places that it wrote. A kernel that includes this file declares
// "#pragma multi_compile_local _ FLUID_PERIODIC", a keyword of FLUID_MESH_WALLS, and before it
//   struct PairSums
//   void AddPair(inout PairSums sums, uint other, float w, float3 d, float distanceSquared)
// w: what the pass wrote beside the other's place. The particle itself is not among them; of those that are not seen AddPair adds
// nothing: the distance is beyond any R. One that takes long defines LONG_TURNS: two in a turn would need more registers.

#include "CellRows.hlsl"
#include "NeighbourList.hlsl"
#include "MeshWalls.hlsl"

StructuredBuffer<float4> _PositionTerms; // present place, and what is beside it

PairSums ListedPairs(uint id, float3 position, PairSums sums)
{
    const uint count = _Neighbours[_NeighbourCountsBegin + id];
    const bool listed = count <= _ListLength;
    FOR_EACH_RUN(id, listed ? count : 0u, run)
    {
#if defined(LONG_TURNS)
        bool sees;
        const uint j = NextListed(run, sees);
        const float4 place = _PositionTerms[j];
        const float3 d = Separation(position, place.xyz);
        AddPair(sums, j, place.w, d, SeenSquared(sees, dot(d, d)));
#else
        const ListPair pair = NextPair(run);
        const float4 first = _PositionTerms[pair.First];
        const float4 second = _PositionTerms[pair.Second];
        const float3 toFirst = Separation(position, first.xyz);
        const float3 toSecond = Separation(position, second.xyz);
        AddPair(sums, pair.First, first.w, toFirst, SeenSquared(pair.SeesFirst, dot(toFirst, toFirst)));
        AddPair(sums, pair.Second, second.w, toSecond, SeenSquared(pair.SeesSecond, dot(toSecond, toSecond)));
#endif
    }
    const uint cell = SortedCell(id, !listed);
    FOR_EACH_NEAR_IF(!listed, CellOf(cell), other)
    {
        const float4 next = _PositionTerms[other];
        const float3 apart = Separation(position, next.xyz);
        const float squared = dot(apart, apart);
        [branch]
        if (IsUnlistedPair(squared * _InverseSupport * _InverseSupport < 1.0 && other != id, id, position, other, next.xyz, apart))
        {
            AddPair(sums, other, next.w, apart, squared);
        }
    }
    return sums;
}

#endif
