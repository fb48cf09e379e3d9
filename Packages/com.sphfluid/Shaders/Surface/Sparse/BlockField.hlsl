// The field of marching cubes in a block and one sample around it, read into groupshared memory: what gradients at the
// block's vertices need.
#ifndef SPHFLUID_BLOCK_FIELD_INCLUDED
#define SPHFLUID_BLOCK_FIELD_INCLUDED

#include "../SurfaceGrid.hlsl"
#include "SurfaceBlocks.hlsl"

StructuredBuffer<uint> _BlockTable;
StructuredBuffer<float> _BlockSamples;

#define FIELD_SIDE 11
#define FIELD_ROWS 121u    // along x
#define FIELD_PLACES 125u
#define FIELD_UNKNOWN -1.0 // no active block holds the sample; field values are 0 and more
#define NO_SOURCE 0xffffffffu

groupshared float fieldValues[FIELD_SIDE * FIELD_SIDE * FIELD_SIDE];
// Where _BlockSamples holds the samples of a place, less their index in the block. Places along an axis: samples -1; 0;
// 1 to 7; 8; 9 of the block.
groupshared uint fieldSources[FIELD_PLACES];
static int3 fieldOrigin; // sample that the field begins at, one before the block's

uint FieldIndex(int3 local)
{
    return uint((local.z * FIELD_SIDE + local.y) * FIELD_SIDE + local.x);
}

uint BlockEntry(int3 block)
{
    const bool exists = all(block >= 0) && all(block < _BlockCounts);
    return exists ? _BlockTable[exists ? BlockNumber(block) : 0u] : BLOCK_NONE; // both sides of a ?: are evaluated
}

// Samples 0 and 8 lie in the next block too: whichever blocks are active, all that need a sample find it or none does,
// so that they make the same normals of it. A barrier must follow.
void FindFieldSource(int3 block, uint index)
{
    const int3 place = int3(index % 5u, index / 5u % 5u, index / 25u);
    const int3 nearest = int3(place == 4) - int3(place == 0);
    const int3 other = int3(place == 3) - int3(place == 1);
    uint source = NO_SOURCE;
    [loop]
    for (uint k = 0u; k < 8u && source == NO_SOURCE; k++)
    {
        const int3 step = nearest + other * int3(k & 1u, k >> 1 & 1u, k >> 2);
        const uint entry = BlockEntry(block + step);
        if (HasSlot(entry))
            source = BlockSampleIndex(entry - 1u, -BLOCK_CUBES * step);
    }
    fieldSources[index] = source;
}

void LoadFieldSample(uint source, int3 local)
{
    float value = FIELD_UNKNOWN;
    if (source != NO_SOURCE)
        value = _BlockSamples[source + BlockSampleIndex(0u, local)];
    fieldValues[FieldIndex(local + 1)] = value;
}

// Reads a row along x; a barrier must follow.
void LoadFieldRow(uint row)
{
    const int2 at = int2(row % FIELD_SIDE, row / FIELD_SIDE) - 1;
    const int2 place = int2(at >= 0) + int2(at >= 1) + int2(at >= BLOCK_CUBES) + int2(at > BLOCK_CUBES);
    const int first = (place.y * 5 + place.x) * 5;
    LoadFieldSample(fieldSources[first], int3(-1, at));
    LoadFieldSample(fieldSources[first + 1], int3(0, at));
    const uint source = fieldSources[first + 2];
    [loop]
    for (int x = 1; x < BLOCK_CUBES; x++)
        LoadFieldSample(source, int3(x, at));
    LoadFieldSample(fieldSources[first + 3], int3(BLOCK_CUBES, at));
    LoadFieldSample(fieldSources[first + 4], int3(BLOCK_SIDE, at));
}

float MCFieldValue(int3 v)
{
    return fieldValues[FieldIndex(v - fieldOrigin)];
}

bool HasFieldValue(int3 v)
{
    return MCInGrid(v) && MCFieldValue(v) != FIELD_UNKNOWN;
}

float MCKnownValue(int3 v)
{
    return MCFieldValue(v);
}

int3 MCKnownAbove(int3 v)
{
    return v + int3(HasFieldValue(v + int3(1, 0, 0)), HasFieldValue(v + int3(0, 1, 0)), HasFieldValue(v + int3(0, 0, 1)));
}

int3 MCKnownBelow(int3 v)
{
    return v - int3(HasFieldValue(v - int3(1, 0, 0)), HasFieldValue(v - int3(0, 1, 0)), HasFieldValue(v - int3(0, 0, 1)));
}

#endif
