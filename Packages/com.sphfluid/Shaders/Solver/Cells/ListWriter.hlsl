#ifndef SPHFLUID_LIST_WRITER
#define SPHFLUID_LIST_WRITER

// Puts a particle's list of neighbours together (NeighbourList.hlsl), one after the other. Half a pair stands there as a pair of one. Near triangles every run has its word of who is
// behind a face, and no more pairs than that has bits for.
#include "NeighbourList.hlsl"

#if defined(FLUID_MESH_WALLS)
#define HEAD_WORDS 2u
#define HEAD_FLAGS LIST_HIDES
#define RUN_PAIRS 16u
#else
#define HEAD_WORDS 1u
#define HEAD_FLAGS 0u
#define RUN_PAIRS LIST_PAIRS
#endif

struct ListWriter
{
    uint Head;  // where the run begins
    uint At;    // where its next pair is written
    uint Limit; // of the run; 0: the column is full
    uint Jump;  // to the run's first
    uint Last;  // neighbour
    uint Pair;
    uint Half;  // the lowest bit of the next in it
    uint Count;
};

ListWriter EmptyList(uint id)
{
    ListWriter list = (ListWriter)0;
    list.Head = ListPlace(id, 0u);
    list.Last = id;
    return list;
}

void CloseRun(ListWriter list, uint flags)
{
    const uint begin = list.Head + HEAD_WORDS * LIST_LANES;
    const uint pairs = (list.At - begin) / LIST_LANES + list.Half / 16u;
    _NeighboursOut[list.Head] = (list.Jump & 0xffffffu) | HEAD_FLAGS | flags | pairs * LIST_PAIR;
#if defined(FLUID_MESH_WALLS)
    _NeighboursOut[list.Head + LIST_LANES] = 0u;
#endif
}

// jump: to the run's first.
void BeginRun(inout ListWriter list, uint id, uint jump)
{
    if (list.Limit != 0u)
    {
        CloseRun(list, LIST_GOES_ON);
        list.Head = list.At + list.Half * (LIST_LANES / 16u);
    }
    const uint end = ListPlace(id, _ListLength / 2u);
    const uint at = list.Head + HEAD_WORDS * LIST_LANES;
    const bool isFull = at >= end || asuint(asint(jump << 8u) >> 8) != jump || (list.Limit == 0u && list.Count > 0u);
    // What follows then goes where the count is to stand.
    list.At = isFull ? _NeighbourCountsBegin + id : at;
    list.Limit = isFull ? 0u : min(end, at + RUN_PAIRS * LIST_LANES);
    list.Jump = jump;
    list.Half = 0u;
}

void AddToList(inout ListWriter list, uint id, uint j)
{
    uint further = j - list.Last;
    [branch]
    if (further > 0xffffu || list.At >= list.Limit)
    {
        BeginRun(list, id, further);
        further = 0u;
    }
    list.Pair = (list.Half != 0u ? list.Pair : 0u) | further << list.Half;
    _NeighboursOut[list.At] = list.Pair;
    list.At += list.Half * (LIST_LANES / 16u);
    list.Half ^= 16u;
    list.Last = j;
    list.Count++;
}

// How many neighbours there are; more than _ListLength where the column does not hold them.
uint EndList(ListWriter list)
{
    if (list.Limit != 0u)
    {
        CloseRun(list, 0u);
    }
    return list.Limit != 0u || list.Count == 0u ? list.Count : max(list.Count, _ListLength + 1u);
}

#endif
