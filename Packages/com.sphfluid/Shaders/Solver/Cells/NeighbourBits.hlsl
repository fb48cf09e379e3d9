#ifndef SPHFLUID_NEIGHBOUR_BITS
#define SPHFLUID_NEIGHBOUR_BITS

// The search in two loops: one tests candidates and keeps a bit of each, the other goes through the bits that are set. Lanes find their
// neighbours in different turns, so a single loop would do a neighbour's work in nearly all of its turns, for a few lanes each time.
// Worked example, 64 lanes, 176 candidates and 28 neighbours each: 211 turns of the first loop and 34 of the second.
#include "CellRows.hlsl"
#include "MeetingReach.hlsl"

#define CHUNK 32u  // candidates of a word
#define CHUNKS 12u // with a neighbour, that wait for the second loop; those of a lane that has more take turns

groupshared uint2 waiting[CHUNKS * CELL_THREADS]; // first particle of a chunk and its bits; each lane has its own

StructuredBuffer<float4> _Positions; // as sorted; w: MeetingReach.hlsl; three more than there are particles

// Whether a particle is within R or may come there.
bool IsNear(float4 place, uint j)
{
    const float4 other = _Positions[j];
    const float3 d = Separation(place.xyz, other.xyz);
    return dot(d, d) < MeetingSquared(place.w, other.w);
}

// Bits of the neighbours among the first candidates of a run, itself not among them. Four in a turn, and up to three behind the last of
// the run, so that loads do not wait for each other. Shifts of constants: FXC drops the top bit of a condition that is shifted.
uint NeighbourBits(uint2 run, uint id, float4 place)
{
    const uint count = min(run.y - run.x, CHUNK);
    const uint end = run.x + count;
    uint bits = 0u;
    for (uint j = run.x; j < end; j += 4u)
    {
        uint four = IsNear(place, j) ? 1u << 28u : 0u;
        four |= IsNear(place, j + 1u) ? 1u << 29u : 0u;
        four |= IsNear(place, j + 2u) ? 1u << 30u : 0u;
        four |= IsNear(place, j + 3u) ? 1u << 31u : 0u;
        bits = (bits >> 4u) | four;
    }
    // Worked example, 6 candidates: two turns leave their bits in the top eight, two of these are not of the run.
    bits >>= 28u - ((count - 1u) & 28u);
    bits &= 0xffffffffu >> ((CHUNK - count) & 31u);
    const uint own = id - run.x;
    return own < CHUNK ? bits & ~(1u << own) : bits;
}

#endif
