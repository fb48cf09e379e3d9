#ifndef SPHFLUID_NEIGHBOUR_SUMS
#define SPHFLUID_NEIGHBOUR_SUMS

// Sums over the neighbours of a particle, by a pass that finds them and by passes that go through its list.
// A kernel that includes this file declares "#pragma multi_compile_local _ FLUID_PERIODIC", "#pragma multi_compile_local _ FLUID_MESH_WALLS",
// and before it
//   struct NeighbourSums
//   NeighbourSums OwnSums()                                                        what a particle adds itself
//   void AddNeighbour(inout NeighbourSums sums, float3 d, float distanceSquared)   what another adds, nothing beyond R
// SearchedSums sums over the cells around and lists the neighbours. ListedSums sums over that list, from present
// places: who has come within R since the sort is left out, and its share would be small, (1 - q)^4. At triangles
// both note in the list who is behind a face: what a curved body cuts off changes from step to step, for both of a pair alike.

#include "NeighbourList.hlsl"
#include "NeighbourBits.hlsl"
#include "FaceWalls.hlsl"
#include "MeshWalls.hlsl"

StructuredBuffer<float4> _NewPositions; // where the last step or pass left them
StructuredBuffer<float4> _Velocities;
RWStructuredBuffer<uint> _NeighboursOut;
RWStructuredBuffer<uint> _NeighbourCountsOut;

#if defined(FLUID_MESH_WALLS)

RWByteAddressBuffer _ContactArgumentsOut; // emptied here for FindContacts of the same step: groups x, y, z and the number of particles

// Adds another particle unless it is behind a face.
void AddBeside(inout NeighbourSums sums, uint slot, uint other, float3 position, float3 otherPosition)
{
    const float3 d = Separation(position, otherPosition);
    const float distanceSquared = dot(d, d);
    [branch]
    if (distanceSquared < _SupportSquared)
    {
        if (!IsCut(WallOf(slot, position), other, otherPosition, d))
        {
            AddNeighbour(sums, d, distanceSquared);
        }
    }
}

// Who of the list is behind a face as things stand.
void NoteBehind(NearWall wall, uint begin, uint end, float3 position)
{
    for (uint at = begin; at < end; at += LIST_LANES)
    {
        const uint entry = _NeighboursOut[at];
        const uint k = ListedParticle(entry);
        const float3 next = _NewPositions[k].xyz;
        const uint noted = IsCut(wall, k, next, Separation(position, next)) ? k | LIST_BEHIND : k;
        if (noted != entry)
        {
            _NeighboursOut[at] = noted;
        }
    }
}

#endif

void EmptyContacts(uint id)
{
#if defined(FLUID_MESH_WALLS)
    if (id < 4u)
    {
        _ContactArgumentsOut.Store(4u * id, id == 1u || id == 2u ? 1u : 0u);
    }
#endif
}

// at: where the next entry would stand.
void EndList(uint id, uint at)
{
    const uint count = (at - ListPlace(id, 0u)) / LIST_LANES;
    if (count % 2u != 0u && count < _ListLength)
    {
        _NeighboursOut[at] = id;
    }
    _NeighbourCountsOut[id] = count;
}

// place: as sorted. walls: what its walls add.
NeighbourSums SearchedSums(uint id, uint groupIndex, float4 place, out WallDensity walls)
{
    const float3 position = place.xyz;
    const int3 cell = CellAt(position);
    walls = DomainWalls(position);
    NeighbourSums sums = OwnSums();
    const uint begin = ListPlace(id, 0u);
    const uint end = ListPlace(id, _ListLength);
    uint at = begin;
    uint row = 0u;
    uint2 run = CellRun(cell, 0u);
    while (row < CELL_RUNS)
    {
        uint first = groupIndex;
        uint behind = groupIndex;
        while (row < CELL_RUNS && behind < CHUNKS * CELL_THREADS)
        {
            const uint bits = NeighbourBits(run, id, place);
            waiting[behind] = uint2(run.x, bits);
            behind += bits != 0u ? CELL_THREADS : 0u;
            run.x += CHUNK;
            if (run.x >= run.y)
            {
                row++;
                run = CellRun(cell, min(row, CELL_RUNS - 1u));
            }
        }
        uint2 chunk = uint2(0u, 0u);
        while (first < behind || chunk.y != 0u)
        {
            if (chunk.y == 0u)
            {
                chunk = waiting[first];
                first += CELL_THREADS;
            }
            const uint j = chunk.x + firstbitlow(chunk.y);
            chunk.y &= chunk.y - 1u;
            const float4 other = _Positions[j];
            const float3 d = Separation(position, other.xyz);
            const float distanceSquared = dot(d, d);
            AddNeighbour(sums, d, distanceSquared);
            bool counts = distanceSquared < _SupportSquared;
            [branch]
            if (!counts && LooksAhead(min(place.w, other.w)))
            {
                counts = Meets(d, _Velocities[id].xyz - _Velocities[j].xyz);
            }
            if (counts && at < end)
            {
                _NeighboursOut[at] = j;
            }
            at += counts ? LIST_LANES : 0u;
        }
    }
#if defined(FLUID_MESH_WALLS)
    const uint slot = _WallSlot[id];
    walls = MeshDensity(slot, position, walls);
    const bool listed = at <= end;
    if (slot != 0u)
    {
        sums = OwnSums(); // anew: what is behind a face is left out
    }
    [branch]
    if (slot != 0u && listed)
    {
        const NearWall wall = WallOf(slot, position);
        for (uint n = begin; n < at; n += LIST_LANES)
        {
            const uint k = _NeighboursOut[n];
            const float3 next = _Positions[k].xyz;
            const float3 apart = Separation(position, next);
            if (IsCut(wall, k, next, apart))
            {
                _NeighboursOut[n] = k | LIST_BEHIND;
            }
            else
            {
                AddNeighbour(sums, apart, dot(apart, apart));
            }
        }
    }
    FOR_EACH_NEAR_IF(slot != 0u && !listed, cell, m)
    {
        if (m != id)
        {
            AddBeside(sums, slot, m, position, _Positions[m].xyz);
        }
    }
#endif
    EndList(id, at);
    return sums;
}

// position: the present one. walls: what its walls add.
NeighbourSums ListedSums(uint id, float3 position, out WallDensity walls)
{
    walls = DomainWalls(position);
#if defined(FLUID_MESH_WALLS)
    const uint slot = _WallSlot[id];
    walls = MeshDensity(slot, position, walls);
#endif
    const uint count = _NeighbourCountsOut[id];
    const bool listed = count <= _ListLength;
    const uint begin = ListPlace(id, 0u);
    const uint end = begin + (listed ? count : 0u) * LIST_LANES;
    NeighbourSums sums = OwnSums();
#if defined(FLUID_MESH_WALLS)
    [branch]
    if (slot != 0u)
    {
        NoteBehind(WallOf(slot, position), begin, end, position);
    }
#endif
    for (uint at = begin; at < end; at += LIST_LANES)
    {
        const uint entry = _NeighboursOut[at];
        const float3 d = Separation(position, _NewPositions[ListedParticle(entry)].xyz);
        AddNeighbour(sums, d, SeenSquared(entry, dot(d, d)));
    }
    FOR_EACH_NEAR_IF(!listed, CellAt(_Positions[id].xyz), j) // the particles of the cells at the sort
    {
        const float3 other = _NewPositions[j].xyz;
#if defined(FLUID_MESH_WALLS)
        [branch]
        if (slot != 0u && j != id)
        {
            AddBeside(sums, slot, j, position, other);
        }
        const bool isFree = slot == 0u && j != id;
#else
        const bool isFree = j != id;
#endif
        [branch]
        if (isFree)
        {
            const float3 apart = Separation(position, other);
            AddNeighbour(sums, apart, dot(apart, apart));
        }
    }
    return sums;
}

#endif
