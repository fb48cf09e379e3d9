#ifndef SPHFLUID_NEIGHBOUR_LIST
#define SPHFLUID_NEIGHBOUR_LIST

// Neighbours that the density pass found, for the motion pass of the same step. 32 particles lie side by side: their n-th entries are
// one line of memory. Worked example: particle 33, the second of its 32, length 72: entry 0 stands at 72 * 32 + 1, entry 1 32 behind.
// After an odd number of neighbours stands the particle itself, which is at no distance and at rest to itself: the motion pass takes
// two in a turn and need not ask. The length is even, so it has its place.
#define LIST_LANES 32u // mirrored by NeighbourList.Lanes

uint _ListLength; // most neighbours of a particle that are listed; who has more searches again: all, where it is 0

uint ListPlace(uint id, uint n)
{
    return (id / LIST_LANES * _ListLength + n) * LIST_LANES + id % LIST_LANES;
}

#endif
