#ifndef SPHFLUID_LIST_WRITER
#define SPHFLUID_LIST_WRITER

// Puts a particle's list of neighbours together (NeighbourList.hlsl), one after the other. Half a pair stands there as a pair of one.
#include "NeighbourList.hlsl"

#define HIDDEN_PAIRS 16u // that a word has bits for

struct ListWriter
{
    uint Head;   // where the run begins,
    uint Begin;  // and its pairs
    uint At;     // where the next pair is written
    uint Limit;  // of the run; 0: the column is full, or empty
    uint Jump;   // to the run's first
    uint Last;   // neighbour
    uint Pair;
    uint Half;   // the lowest bit of the next in it
    uint Hidden; // pairs before this run that the last word of who is behind a face has bits for
    uint Count;
};

ListWriter EmptyList(uint id)
{
    ListWriter list = (ListWriter)0;
    list.Head = ListPlace(id, 0u);
    list.Last = id;
    return list;
}

uint PairsOf(ListWriter list)
{
    return (list.At - list.Begin) / LIST_LANES + list.Half / 16u;
}

// Returns nothing: FXC aborts where a function writes to a buffer and its result is used.
void CloseRun(ListWriter list, uint flags)
{
    const uint hides = list.Begin > list.Head + LIST_LANES ? LIST_HIDES : 0u;
    _NeighboursOut[list.Head] = (list.Jump & 0xffffffu) | hides | flags | PairsOf(list) * LIST_PAIR;
}

// jump: to the run's first.
void BeginRun(inout ListWriter list, uint id, uint jump)
{
    if (list.Limit != 0u)
    {
        CloseRun(list, LIST_GOES_ON);
        list.Hidden += PairsOf(list);
        list.Head = list.At + list.Half * (LIST_LANES / 16u);
    }
    const uint end = ListPlace(id, LIST_WORDS);
    const bool isFull = (list.Limit == 0u && list.Count > 0u) || asuint(asint(jump << 8u) >> 8) != jump;
    list.Begin = list.Head + LIST_LANES;
    uint pairs = LIST_PAIRS;
#if defined(FLUID_MESH_WALLS)
    [branch]
    if (list.Hidden % HIDDEN_PAIRS == 0u)
    {
        if (list.Begin < end)
        {
            _NeighboursOut[list.Begin] = 0u;
        }
        list.Begin += LIST_LANES;
    }
    pairs = HIDDEN_PAIRS - list.Hidden % HIDDEN_PAIRS;
#endif
    // Of a list that does not fit, what follows goes where the count is to stand.
    const bool fits = list.Begin < end && !isFull;
    list.At = fits ? list.Begin : _NeighbourCountsBegin + id;
    list.Limit = fits ? min(end, list.Begin + pairs * LIST_LANES) : 0u;
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
