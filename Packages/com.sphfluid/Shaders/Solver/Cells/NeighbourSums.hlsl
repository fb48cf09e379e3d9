#ifndef SPHFLUID_NEIGHBOUR_SUMS
#define SPHFLUID_NEIGHBOUR_SUMS

// Sums over the neighbours of a particle. A kernel that includes this file declares "#pragma multi_compile_local _ FLUID_PERIODIC",
// "#pragma multi_compile_local _ FLUID_MESH_WALLS", and before it
//   struct NeighbourSums
//   NeighbourSums OwnSums(float3 position)                                         what a particle adds itself
//   void AddNeighbour(inout NeighbourSums sums, float3 d, float distanceSquared)   what another adds, nothing beyond R
#define WRITES_LISTS
#include "NeighbourSearch.hlsl"
#include "NeighbourList.hlsl"
#include "MeshWalls.hlsl"

// Where the particles are: as sorted in a kernel that searches, which defines SEARCHES; else where the last step or pass left them.
#if defined(SEARCHES)
#define PLACES _Positions
#else
#define PLACES _Places
StructuredBuffer<float4> _Places;
#endif

#if defined(FLUID_MESH_WALLS)

// Notes in a list who is behind a face as things stand: what a curved body cuts off changes from step to step, for both of a pair alike.
void NoteBehind(NearWall wall, float3 position, uint begin, uint end)
{
    for (uint at = begin; at < end; at += LIST_LANES)
    {
        const uint entry = _NeighboursOut[at];
        const uint j = ListedParticle(entry);
        const float3 other = PLACES[j].xyz;
        const uint noted = IsCut(wall, j, other, Separation(position, other)) ? j | LIST_BEHIND : j;
        if (noted != entry)
        {
            _NeighboursOut[at] = noted;
        }
    }
}

#endif

// By the list of an earlier search: who has come within R since is left out, and its share would be small, (1 - q)^4.
NeighbourSums ListedSums(uint id, uint count, float3 position)
{
    const bool listed = count <= _ListLength;
    const uint begin = ListPlace(id, 0u);
    const uint end = begin + (listed ? count : 0u) * LIST_LANES;
    const uint slot = WallSlot(id);
#if defined(FLUID_MESH_WALLS)
    [branch]
    if (slot != 0u)
    {
        NoteBehind(WallOf(slot, position), position, begin, end);
    }
#endif
    NeighbourSums sums = OwnSums(position);
    for (uint at = begin; at < end; at += LIST_LANES)
    {
        const uint entry = _NeighboursOut[at];
        const float3 d = Separation(position, PLACES[ListedParticle(entry)].xyz);
        AddNeighbour(sums, d, SeenSquared(entry, dot(d, d)));
    }
    const uint cell = SortedCell(id, !listed);
    FOR_EACH_NEAR_IF(!listed, CellOf(cell), j)
    {
        const float3 other = PLACES[j].xyz;
        const float3 apart = Separation(position, other);
        const bool isNear = dot(apart, apart) < _SupportSquared;
        [branch]
        if (j != id && !IsParted(isNear ? slot : 0u, position, j, other, apart)) // beyond R nothing is added
        {
            AddNeighbour(sums, apart, dot(apart, apart));
        }
    }
    return sums;
}

// By the cells around; lists the neighbours, and those who meet later. place: as sorted.
NeighbourSums SearchedSums(uint id, uint lane, float4 place)
{
    const int3 cell = CellAt(place.xyz);
    const uint end = ListPlace(id, _ListLength);
    uint at = ListPlace(id, 0u);
    NeighbourSums sums = OwnSums(place.xyz);
    Search search = (Search)0;
    search.Run = CellRun(cell, 0u);
    while (search.Row < CELL_RUNS)
    {
        FillChunks(search, cell, lane, id, place);
        while (search.Next < search.End || search.Chunk.y != 0u)
        {
            const uint j = NextFound(search);
            const float4 other = _Positions[j];
            const float3 d = Separation(place.xyz, other.xyz);
            const float distanceSquared = dot(d, d);
            AddNeighbour(sums, d, distanceSquared);
            bool counts = distanceSquared < _SupportSquared;
            [branch]
            if (!counts && min(place.w, other.w) > LEAST_MEETING_REACH * _SupportSquared)
            {
                counts = Meet(d, id, j);
            }
            if (counts && at < end)
            {
                _NeighboursOut[at] = j;
            }
            at += counts ? LIST_LANES : 0u;
        }
    }
    const uint count = (at - ListPlace(id, 0u)) / LIST_LANES;
    if (count % 2u != 0u && count < _ListLength)
    {
        _NeighboursOut[at] = id;
    }
    _NeighboursOut[_NeighbourCountsBegin + id] = count;
#if defined(FLUID_MESH_WALLS)
    [branch]
    if (WallSlot(id) != 0u)
    {
        sums = ListedSums(id, count, place.xyz); // anew: what is behind a face is left out
    }
#endif
    return sums;
}

#endif
