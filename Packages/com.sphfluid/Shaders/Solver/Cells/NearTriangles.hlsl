#ifndef SPHFLUID_NEAR_TRIANGLES
#define SPHFLUID_NEAR_TRIANGLES

// The triangles of a cell's list that a particle still has to look at: those found to be far are passed over from then on. Of the first
// ones of all bodies there is a bit each, of those behind none is passed over.
#include "../../Collision/Bodies.hlsl"

#define NEAR_WORDS 4u // 128 triangles; lists of Dam Break have 24

groupshared uint nearBits[NEAR_WORDS * CELL_THREADS]; // words of the same number side by side; each thread has its own

struct NearTriangles
{
    uint2 Range;  // of the body's list
    uint Word;    // in which its bits begin
    uint Thread;
};

// The list of the cell that a place of a body's frame is in; cells are those of the body as it was before it stretched.
uint2 NearRange(CollisionBody body, BodyPose pose, float3 place)
{
#if defined(FLUID_STRETCHED_BODIES)
    return BodyCellRange(body, Apply(pose.Relaxed, place));
#else
    return BodyCellRange(body, place);
#endif
}

void AllAreNear(uint thread)
{
    [unroll]
    for (uint word = 0u; word < NEAR_WORDS; word++)
    {
        nearBits[word * CELL_THREADS + thread] = 0xffffffffu;
    }
}

// Those of the first body, and of the next.
NearTriangles NearOf(uint2 range, uint word, uint thread)
{
    NearTriangles near;
    near.Range = range;
    near.Word = word;
    near.Thread = thread;
    return near;
}

uint WordBehind(NearTriangles near)
{
    return near.Word + (near.Range.y - near.Range.x + 31u) / 32u;
}

// The first that is near, from a place of the list on; its end where there is none.
uint NextNear(NearTriangles near, uint from)
{
    uint next = from;
    bool seeks = next < near.Range.y;
    [loop]
    while (seeks)
    {
        const uint offset = next - near.Range.x;
        const uint word = near.Word + offset / 32u;
        const uint bits = word < NEAR_WORDS ? nearBits[min(word, NEAR_WORDS - 1u) * CELL_THREADS + near.Thread] >> (offset & 31u) : 1u;
        next = bits != 0u ? next + firstbitlow(bits) : near.Range.x + (offset | 31u) + 1u;
        seeks = bits == 0u && next < near.Range.y;
    }
    return min(next, near.Range.y);
}

void PassOver(NearTriangles near, uint place)
{
    const uint offset = place - near.Range.x;
    const uint word = near.Word + offset / 32u;
    if (word < NEAR_WORDS)
    {
        nearBits[word * CELL_THREADS + near.Thread] &= ~(1u << (offset & 31u));
    }
}

#endif
