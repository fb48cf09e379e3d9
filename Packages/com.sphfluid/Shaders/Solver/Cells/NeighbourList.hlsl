#ifndef SPHFLUID_NEIGHBOUR_LIST
#define SPHFLUID_NEIGHBOUR_LIST

// Neighbours that the density pass found. 32 particles lie side by side: their n-th entries are one line of memory. Worked example:
// particle 33, the second of its 32, length 72: entry 0 stands at 72 * 32 + 1, entry 1 32 behind. After an odd number of neighbours stands
// the particle itself: who takes two in a turn need not ask. The length is even, so it has its place.
#define LIST_LANES 32u // mirrored by NeighbourList.Lanes

// Entries of particles that are behind a face, as things stand, have a bit more: every density pass notes it anew.
#define LIST_BEHIND 0x80000000u

StructuredBuffer<uint> _Neighbours;
RWStructuredBuffer<uint> _NeighboursOut;

// A kernel that lists reads where it writes.
#if defined(WRITES_LISTS)
#define LISTS _NeighboursOut
#else
#define LISTS _Neighbours
#endif

// Behind the entries of all particles stand numbers of each.
uint _NeighbourCountsBegin; // how many neighbours it has, listed or not
uint _DensitiesBegin;       // kg/m^3, as bits
uint _WallSlotBegin;        // 0: no walls; else 1 + their place in _NearWalls
uint _WallBodiesBegin;      // of each plane of its walls the number of a body that the liquid moves, in BODY_NUMBER_BITS; 0: no such body

uint _ListLength; // most neighbours of a particle that are listed; who has more searches again: all, where it is 0

uint ListPlace(uint id, uint n)
{
    return (id / LIST_LANES * _ListLength + n) * LIST_LANES + id % LIST_LANES;
}

bool IsBehind(uint entry)
{
    return entry >= LIST_BEHIND;
}

uint ParticleOf(uint entry)
{
    return entry & ~LIST_BEHIND;
}

#if defined(FLUID_MESH_WALLS)
#define ListedParticle(entry) ParticleOf(entry)
#else
#define ListedParticle(entry) (entry) // without triangles none is behind a face
#endif

// The squared distance of an entry, or one beyond any R: what is behind a face is neither felt nor counted.
float SeenSquared(uint entry, float distanceSquared)
{
#if defined(FLUID_MESH_WALLS)
    distanceSquared = IsBehind(entry) ? 1e30 : distanceSquared;
#endif
    return distanceSquared;
}

#endif
