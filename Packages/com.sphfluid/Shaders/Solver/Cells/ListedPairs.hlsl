#ifndef SPHFLUID_LISTED_PAIRS
#define SPHFLUID_LISTED_PAIRS

// Sums over the pairs that an earlier pass listed, at the places that it wrote. A kernel that includes this file declares
// "#pragma multi_compile_local _ FLUID_PERIODIC", a keyword of FLUID_MESH_WALLS, and before it
//   struct PairSums
//   void AddPair(inout PairSums sums, uint other, float w, float3 d, float distanceSquared)
// w: what the pass wrote beside the other's place. The particle itself is not among them; of those behind a face AddPair adds nothing:
// the distance is beyond any R.

#include "CellRows.hlsl"
#include "NeighbourList.hlsl"
#include "MeshWalls.hlsl"

StructuredBuffer<float4> _PositionTerms; // present place, and what is beside it

PairSums ListedPairs(uint id, float3 position, PairSums sums)
{
    const uint count = _Neighbours[_NeighbourCountsBegin + id];
    const bool listed = count <= _ListLength;
    const uint begin = ListPlace(id, 0u);
    const uint end = begin + (listed ? count : 0u) * LIST_LANES;
    for (uint at = begin; at < end; at += LIST_LANES)
    {
        const uint entry = _Neighbours[at];
        const uint j = ListedParticle(entry);
        const float4 place = _PositionTerms[j];
        const float3 d = Separation(position, place.xyz);
        AddPair(sums, j, place.w, d, SeenSquared(entry, dot(d, d)));
    }
    const uint cell = SortedCell(id, !listed);
    FOR_EACH_NEAR_IF(!listed, CellOf(cell), other)
    {
        const float4 next = _PositionTerms[other];
        const float3 apart = Separation(position, next.xyz);
        const bool isNear = dot(apart, apart) * _InverseSupport * _InverseSupport < 1.0 && other != id;
        [branch]
        if (isNear && !IsParted(isNear ? WallSlot(id) : 0u, position, other, next.xyz, apart))
        {
            AddPair(sums, other, next.w, apart, dot(apart, apart));
        }
    }
    return sums;
}

#endif
