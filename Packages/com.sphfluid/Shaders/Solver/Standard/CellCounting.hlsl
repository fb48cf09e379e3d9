#ifndef SPHFLUID_CELL_COUNTING
#define SPHFLUID_CELL_COUNTING

#include "../../Gpu/FluidCounters.hlsl"
#include "CellSums.hlsl"
#include "../DomainFaces.hlsl"

// The last word of a step on a particle: where the next step sorts, it is counted into the cell of its new place or, beyond an open
// face, taken out of the liquid. A particle that left keeps its place and velocity and stands behind all others from then on.
RWStructuredBuffer<float4> _NewPositionsOut; // w: 1 of a particle that left, else 0
RWStructuredBuffer<uint> _RankOut;
uint _ParticleCount;
uint _KeepsOrder; // 1: the next step goes on in the order of the last sort, so nothing is counted and nobody leaves

void CountInCell(uint id, float3 position)
{
    bool leaves = false;
    for (bool counts = !Switched(_KeepsOrder); counts; counts = false) // a loop that ends at once is skipped where a branch may not be
    {
        leaves = any(position < _OpenLow) || any(position > _OpenHigh);
        const uint rank = CountCell(leaves ? RemovedCell() : CellNumber(CellAt(position)), id);
        _RankOut[id] = leaves ? rank + _ParticleCount - LiveCount() : rank; // behind those that left before
        if (leaves)
        {
            CountEvent(COUNTER_REMOVED);
        }
    }
    _NewPositionsOut[id] = float4(position, leaves ? 1.0 : 0.0);
}

#endif
