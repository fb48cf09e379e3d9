// The field of marching cubes in a block and one sample around it, read into groupshared memory: what gradients at the block's vertices need.
#ifndef SPHFLUID_BLOCK_FIELD_INCLUDED
#define SPHFLUID_BLOCK_FIELD_INCLUDED

#include "../SurfaceGrid.hlsl"
#include "BlockSamples.hlsl"

#define FIELD_SIDE 11
#define FIELD_SAMPLES 1331u
#define FIELD_UNKNOWN -1.0 // no active block holds the sample; field values are 0 and more

groupshared float fieldValues[FIELD_SAMPLES];
groupshared uint nearEntries[27]; // of _BlockTable: the block and those around it; 0 where they have no slot
static int3 fieldOrigin;          // sample that the field begins at, one before the block's

uint FieldIndex(int3 local)
{
    return uint((local.z * FIELD_SIDE + local.y) * FIELD_SIDE + local.x);
}

// Barriers must follow this, and the next before values are used.
void LoadNearEntries(int3 block, uint thread)
{
    if (thread < 27u)
    {
        const int3 near = block + int3(thread % 3u, thread / 3u % 3u, thread / 9u) - 1;
        const bool exists = all(near >= 0) && all(near < _BlockCounts);
        const uint entry = exists ? _BlockTable[BlockNumber(near)] : BLOCK_NONE;
        nearEntries[thread] = HasSlot(entry) ? entry : 0u;
    }
}

// Samples in the outermost layers of a block are in other blocks too: where the nearest has no slot, another may.
float FieldSampleElsewhere(int3 local)
{
    float value = FIELD_UNKNOWN;
    if (any(local == 0 || local == BLOCK_CUBES))
    {
        const uint found = FindSample(fieldOrigin + 1 + local);
        value = found != NO_SAMPLE ? _BlockSamples[found] : FIELD_UNKNOWN;
    }
    return value;
}

void LoadFieldSample(uint index)
{
    const int3 local = int3(index % FIELD_SIDE, index / FIELD_SIDE % FIELD_SIDE, index / (FIELD_SIDE * FIELD_SIDE)) - 1; // in the block
    const int3 step = int3(local > BLOCK_CUBES) - int3(local < 0);
    const uint entry = nearEntries[(step.z * 3 + step.y) * 3 + step.x + 13];
    fieldValues[index] = entry != 0u ? _BlockSamples[BlockSampleIndex(entry - 1u, local - step * BLOCK_CUBES)] : FieldSampleElsewhere(local);
}

float MCFieldValue(int3 v)
{
    return fieldValues[FieldIndex(v - fieldOrigin)];
}

bool MCHasValue(int3 v)
{
    return MCInGrid(v) && MCFieldValue(v) != FIELD_UNKNOWN;
}

#endif
