#ifndef SPHFLUID_NEIGHBOUR_LIST
#define SPHFLUID_NEIGHBOUR_LIST

// Neighbours that the density pass found, for the motion pass of the same step. 32 particles lie side by side: their n-th entries are
// one line of memory. Worked example: particle 33, the second of its 32, length 72: entry 0 stands at 72 * 32 + 1, entry 1 32 behind.
// After an odd number of neighbours stands the particle itself, which is at no distance and at rest to itself: the motion pass takes
// two in a turn and need not ask. The length is even, so it has its place.
// Entries of particles that are behind a face, as things stand, have a bit more: every density pass notes it anew.
#define LIST_BEHIND 0x80000000u
#define LIST_LANES 32u // mirrored by NeighbourList.Lanes

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

// For kernels of the method: without triangles no entry has the bit. The particle of an entry, and its squared distance or one that is
// beyond any R: what is behind a face is neither felt nor counted.
uint ListedParticle(uint entry)
{
#if defined(FLUID_MESH_WALLS)
    return ParticleOf(entry);
#else
    return entry;
#endif
}

float SeenSquared(uint entry, float distanceSquared)
{
#if defined(FLUID_MESH_WALLS)
    return IsBehind(entry) ? 1e30 : distanceSquared;
#else
    return distanceSquared;
#endif
}

#endif
