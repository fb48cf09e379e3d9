#ifndef SPHFLUID_SURFACE_BLOCKS
#define SPHFLUID_SURFACE_BLOCKS

// Blocks of 8^3 cubes and 9^3 samples over a surface grid. Samples (grid vertices) s run from -1 to cells + 1 along an
// axis, cubes o from -1 to cells; a block b holds the samples 8b - 1 to 8b + 7 and the cubes 8b - 1 to 8b + 6.
// Neighbours share a layer of samples: each stores its own.
// Worked example on an axis of 64 cells: 66 cubes, 9 blocks; block 0 has the samples -1 to 7, block 1 those from 7 to
// 15.
#define BLOCK_CUBES 8
#define BLOCK_SIDE 9
#define BLOCK_SAMPLES 729u

// Entries of _BlockTable, one a block of the grid: 0, BLOCK_MARKED, or slot + 1.
#define BLOCK_NONE 0u
#define BLOCK_MARKED 0xffffffffu

int3 _BlockCounts;    // blocks along each axis
uint _BlockCapacity;  // slots that the buffers hold

uint BlockNumber(int3 block)
{
    return uint(block.x + _BlockCounts.x * (block.y + _BlockCounts.y * block.z));
}

int3 BlockAt(uint number)
{
    const uint row = number / uint(_BlockCounts.x);
    const uint layer = row / uint(_BlockCounts.y);
    return int3(number - row * uint(_BlockCounts.x), row - layer * uint(_BlockCounts.y), layer);
}

// The block that a cube belongs to.
int3 BlockOfCube(int3 cube)
{
    return (cube + 1) >> 3;
}

// First sample, and first cube, of a block.
int3 BlockOrigin(int3 block)
{
    return block * BLOCK_CUBES - 1;
}

// Where _BlockSamples holds a sample of a block; local runs from 0 to 8.
uint BlockSampleIndex(uint slot, int3 local)
{
    return slot * BLOCK_SAMPLES + uint((local.z * BLOCK_SIDE + local.y) * BLOCK_SIDE + local.x);
}

// Whether an entry of _BlockTable names a slot.
bool HasSlot(uint entry)
{
    return entry != BLOCK_NONE && entry != BLOCK_MARKED;
}

#endif
