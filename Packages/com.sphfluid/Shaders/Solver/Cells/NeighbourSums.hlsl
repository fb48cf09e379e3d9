#ifndef SPHFLUID_NEIGHBOUR_SUMS
#define SPHFLUID_NEIGHBOUR_SUMS

// Sums over the neighbours of a particle. A kernel that includes this file declares "#pragma multi_compile_local _ FLUID_PERIODIC",
// "#pragma multi_compile_local _ FLUID_MESH_WALLS", and before it
//   struct NeighbourSums
//   NeighbourSums OwnSums(float3 position)                                         what a particle adds itself
//   void AddNeighbour(inout NeighbourSums sums, float3 d, float distanceSquared)   what another adds, nothing beyond R
#define WRITES_LISTS
#include "NeighbourSearch.hlsl"
#include "ListWriter.hlsl"
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
// Bits shift in from above, so that shifts are of constants: FXC drops the top bit of a condition that is shifted.
void NoteBehind(NearWall wall, float3 position, uint id, uint count)
{
    ListRun run = BeforeRuns(id, count);
    uint place = 0u;
    uint hidden = 0u;
    uint spare = 0u; // bits that no neighbour has
    while ((run.Head & LIST_GOES_ON) != 0u)
    {
        OpenRun(run);
        const bool hides = (run.Head & LIST_HIDES) != 0u;
        place = hides ? run.At - LIST_LANES : place;
        spare = hides ? 32u : spare;
        while (run.Head >= LIST_PAIR)
        {
            bool sees;
            const uint j = NextListed(run, sees);
            const float3 other = PLACES[j].xyz;
            hidden = hidden >> 1u | (IsCut(wall, j, other, Separation(position, other)) ? 1u << 31u : 0u);
            spare--;
        }
        if (place != 0u)
        {
            _NeighboursOut[place] = hidden >> (spare & 31u);
        }
    }
}

#endif

// By the list of an earlier search: who has come within R since is left out, and its share would be small, (1 - q)^4.
NeighbourSums ListedSums(uint id, uint count, float3 position)
{
    const bool listed = count <= _ListLength;
    const uint slot = WallSlot(id);
#if defined(FLUID_MESH_WALLS)
    [branch]
    if (slot != 0u)
    {
        NoteBehind(WallOf(slot, position), position, id, listed ? count : 0u);
    }
#endif
    NeighbourSums sums = OwnSums(position);
    FOR_EACH_RUN(id, listed ? count : 0u, run)
    {
        const ListPair pair = NextPair(run);
        const float3 first = Separation(position, PLACES[pair.First].xyz);
        const float3 second = Separation(position, PLACES[pair.Second].xyz);
        AddNeighbour(sums, first, SeenSquared(pair.SeesFirst, dot(first, first)));
        AddNeighbour(sums, second, SeenSquared(pair.SeesSecond, dot(second, second)));
    }
    const uint cell = SortedCell(id, !listed);
    FOR_EACH_NEAR_IF(!listed, CellOf(cell), j)
    {
        const float3 other = PLACES[j].xyz;
        const float3 apart = Separation(position, other);
        [branch]
        if (IsUnlistedPair(dot(apart, apart) < _SupportSquared && j != id, id, position, j, other, apart))
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
    ListWriter list = EmptyList(id);
    NeighbourSums sums = OwnSums(place.xyz);
    Search search = (Search)0;
    search.Words = TableWords();
    search.Run = CellRun(search.Words, cell, 0u);
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
            if (counts)
            {
                AddToList(list, id, j);
            }
        }
    }
    const uint count = EndList(list);
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
