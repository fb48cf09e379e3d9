#ifndef SPHFLUID_MARK_BLOCKS
#define SPHFLUID_MARK_BLOCKS

#include "../../Solver/DomainFaces.hlsl"
#include "../SurfaceGrid.hlsl"
#include "SurfaceBlocks.hlsl"

RWStructuredBuffer<uint> _BlockTable;
float _MarkReach; // m: around a particle near the surface, blocks are active

// Marks the blocks of the cubes from lower to upper. Plain stores: all store the same.
void MarkCubes(int3 lower, int3 upper)
{
    const int3 first = BlockOfCube(clamp(lower, -1, MCCells()));
    const int3 last = BlockOfCube(clamp(upper, -1, MCCells()));
    for (int z = first.z; z <= last.z; z++)
    {
        for (int y = first.y; y <= last.y; y++)
        {
            for (int x = first.x; x <= last.x; x++)
            {
                _BlockTable[BlockNumber(int3(x, y, z))] = BLOCK_MARKED;
            }
        }
    }
}

void MarkAround(float3 position)
{
    const int3 lower = int3(floor((position - _MarkReach - _MCMinimum) / _MCCellSize));
    const int3 upper = int3(floor((position + _MarkReach - _MCMinimum) / _MCCellSize));
    MarkCubes(lower, upper);
#if defined(FLUID_PERIODIC)
    // What reaches over a periodic face comes in at the other: the field there has it too. Over two faces at once, at
    // three other places.
    const int3 below = (_PeriodLength > 0.0 && lower < 0) ? MCCells() : int3(0, 0, 0);
    const int3 above = (_PeriodLength > 0.0 && upper >= MCCells()) ? -MCCells() : int3(0, 0, 0);
    const int3 shift = below + above;
    const uint end = any(shift != 0) ? 8u : 1u;
    for (uint k = 1u; k < end; k++)
    {
        const int3 taken = int3(uint3(k, k >> 1, k >> 2) & 1u);
        const bool isOther = !any(taken != 0 && shift == 0);
        if (isOther)
        {
            MarkCubes(lower + shift * taken, upper + shift * taken);
        }
    }
#endif
}

#endif
