#ifndef SPHFLUID_NEIGHBOUR_SEARCH
#define SPHFLUID_NEIGHBOUR_SEARCH

// The search in two loops: one tests candidates and keeps a bit of each, the other goes through the bits that are set. Lanes find their
// neighbours in different turns, so a single loop would do a neighbour's work in nearly all of its turns, for a few lanes each time.
// Worked example, 64 lanes, 176 candidates and 28 neighbours each: 211 turns of the first loop and 34 of the second.
//
// Lists that serve several steps hold, besides the neighbours at the sort, pairs that come within R before the next: bodies of liquid that
// fall together would else overlap first. Inside the liquid neighbours part and come slowly, so only particles at a surface look ahead.
#include "CellRows.hlsl"

#define CHUNK 32u  // candidates of a word
#define CHUNKS 12u // with a neighbour, that wait for the second loop; those of a lane that has more take turns

groupshared uint2 waiting[CHUNKS * CELL_THREADS]; // first particle of a chunk and its bits; each lane has its own

// As sorted. w: 4 R times how far the particle goes until the next sort, m^2, below zero for one inside the liquid (ScatterParticles).
// Three more than there are particles.
StructuredBuffer<float4> _Positions;
StructuredBuffer<float4> _Velocities;
float _SupportSquared; // R^2, m^2
float _Ahead;          // s from the sort to the last step that uses its lists

// Who goes less than R/50 until the next sort looks nowhere ahead: R^2. A pair of them is late by 1/25 of R at most.
#define LEAST_MEETING_REACH 0.08

// Whether a particle is within R or may come there: (1 + a + b)^2 < 1 + 4 (a + b), over R^2, as a and b are below 1.
// Worked example: two that go 0.1 and 0.3 may from 1.61 R.
bool IsNear(float4 place, uint j)
{
    const float4 other = _Positions[j];
    const float3 d = Separation(place.xyz, other.xyz);
    return dot(d, d) < max(_SupportSquared + place.w + other.w, _SupportSquared);
}

// Whether two particles, d apart, come within R, going straight on.
bool Meet(float3 d, uint i, uint j)
{
    const float3 approach = _Velocities[i].xyz - _Velocities[j].xyz;
    const float time = clamp(-dot(d, approach) / max(dot(approach, approach), 1e-20), 0.0, _Ahead);
    const float3 nearest = d + time * approach;
    return dot(nearest, nearest) < _SupportSquared;
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

struct Search
{
    uint Words;  // of the table
    uint Row;    // whose candidates come next
    uint2 Run;   // what is left of it
    uint Next;   // of the lane's waiting chunks
    uint End;
    uint2 Chunk; // that is gone through
};

// The first loop: until the lane's chunks are full, or no candidate is left.
void FillChunks(inout Search search, int3 cell, uint lane, uint id, float4 place)
{
    search.Next = lane;
    search.End = lane;
    while (search.Row < CELL_RUNS && search.End < CHUNKS * CELL_THREADS)
    {
        const uint bits = NeighbourBits(search.Run, id, place);
        waiting[search.End] = uint2(search.Run.x, bits);
        search.End += bits != 0u ? CELL_THREADS : 0u;
        search.Run.x += CHUNK;
        if (search.Run.x >= search.Run.y)
        {
            search.Row++;
            search.Run = CellRun(search.Words, cell, min(search.Row, CELL_RUNS - 1u));
        }
    }
}

// A turn of the second.
uint NextFound(inout Search search)
{
    if (search.Chunk.y == 0u)
    {
        search.Chunk = waiting[search.Next];
        search.Next += CELL_THREADS;
    }
    const uint found = search.Chunk.x + firstbitlow(search.Chunk.y);
    search.Chunk.y &= search.Chunk.y - 1u;
    return found;
}

#endif
