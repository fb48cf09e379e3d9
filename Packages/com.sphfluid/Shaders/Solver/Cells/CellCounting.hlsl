#ifndef SPHFLUID_CELL_COUNTING
#define SPHFLUID_CELL_COUNTING

#include "../../Gpu/FluidCounters.hlsl"
#include "CellSums.hlsl"
#include "../DomainFaces.hlsl"

// The last word of a step on a particle: where the next step sorts, it is counted into the cell of its new place or, beyond an open
// face or in a drain, taken out of the liquid: the sort leaves it behind.
RWStructuredBuffer<float4> _NewPositionsOut; // w: below zero of a particle that left, else what its method takes along
uint _KeepsOrder; // 1: the next step goes on in the order of the last sort, so nothing is counted and nobody leaves
uint _Drains;     // 1: DrainParticles has gone before

#define DRAINED 0xffffffffu // in place of the rank of a particle that is to leave, where something is drained

// place: the new one; w: what the method takes along.
void CountInCell(uint id, float4 place)
{
    bool isBeyond = false, leaves = false;
    [branch]
    if (_KeepsOrder == 0u)
    {
        leaves = isBeyond = any(place.xyz < _OpenLow) || any(place.xyz > _OpenHigh);
        [branch]
        if (_Drains != 0u)
        {
            leaves = leaves || _CellTableOut[_RankBegin + id] == DRAINED;
        }
        _CellTableOut[_RankBegin + id] = CountCell(leaves ? RemovedCell() : CellNumber(CellAt(place.xyz)), id);
        if (leaves)
        {
            CountEvent(isBeyond ? COUNTER_LEFT_THROUGH_FACE : COUNTER_REMOVED);
        }
    }
    _NewPositionsOut[id] = float4(place.xyz, leaves ? -1.0 : place.w > 0.0 ? place.w : 0.0); // what is not a number is not known
}

#endif
