#ifndef SPHFLUID_BLOCK_SAMPLES
#define SPHFLUID_BLOCK_SAMPLES

#include "SurfaceBlocks.hlsl"

StructuredBuffer<uint> _BlockTable;    // an entry a block of the grid
StructuredBuffer<float> _BlockSamples; // 729 field values a slot

#define NO_SAMPLE 0xffffffffu

// Index in _BlockSamples of a sample in one of the blocks that hold it, NO_SAMPLE where none of them is active. A sample between blocks lies in up to
// eight, all with the same value to the last bit. Worked example: sample 7 is the last of block 0 and the first of block 1.
uint FindSample(int3 s)
{
    const int3 upper = (s + 1) >> 3;
    const int3 local = (s + 1) & 7;
    uint found = NO_SAMPLE;
    for (uint k = 0u; k < 8u && found == NO_SAMPLE; k++)
    {
        const int3 step = int3(uint3(k, k >> 1, k >> 2) & 1u);
        const int3 block = upper - step;
        const bool holds = all(step == 0 || local == 0);
        if (holds && all(block >= 0) && all(block < _BlockCounts))
        {
            const uint entry = _BlockTable[BlockNumber(block)];
            if (HasSlot(entry))
            {
                found = BlockSampleIndex(entry - 1u, local + step * BLOCK_CUBES);
            }
        }
    }
    return found;
}

#endif
