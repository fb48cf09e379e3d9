// Which edges and cubes of a block the surface cuts, in 9 x 9 columns along z with a bit a sample. An edge and a cube
// belong to the column, and have the height, of their lowest sample.
// Worked example: samples 0 to 3 of a column inside the liquid, 4 to 8 outside: bits 000001111; the edge from 3 to 4 is
// cut.
#ifndef SPHFLUID_BLOCK_COLUMNS_INCLUDED
#define SPHFLUID_BLOCK_COLUMNS_INCLUDED

#include "../SurfaceGrid.hlsl"
#include "SurfaceBlocks.hlsl"

#define POLYGON_THREADS 128
#define BLOCK_COLUMNS 81u

groupshared uint inside[BLOCK_COLUMNS]; // bit z: the sample lies inside the liquid

// The cubes of a block that are polygonised: from first to before end along each axis; none where end is not above
// first on every axis.
struct BlockCubes
{
    int3 first;
    int3 end;
};

BlockCubes CubesOf(int3 block)
{
    const int ring = _MCRing > 0.0 ? 1 : 0;
    const int3 origin = BlockOrigin(block);
    BlockCubes cubes;
    cubes.first = max(-ring - origin, 0);
    cubes.end = min(MCCells() + ring - origin, BLOCK_CUBES);
    return cubes;
}

// Bits from first to last.
uint BitRange(int first, int last)
{
    return (2u << uint(last)) - (1u << uint(first));
}

// x and y of a column; 57 / 512 is 1 / 9 as far as 98 columns go, and a product of 24 bits is cheap.
int2 ColumnAt(uint column)
{
    const uint y = ((column & 127u) * 57u) >> 9;
    return int2(column - BLOCK_SIDE * y, y);
}

uint ColumnNumber(int2 at)
{
    return uint(at.y * BLOCK_SIDE + at.x);
}

// Bits of the samples that are corners of polygonised cubes.
uint UsedSamples(BlockCubes cubes, int2 at)
{
    const int3 size = cubes.end - cubes.first; // FXC leaves out all(cubes.end > cubes.first) where this stands
    const bool used = min(size.x, min(size.y, size.z)) > 0 && all(at >= cubes.first.xy) && all(at <= cubes.end.xy);
    return used ? BitRange(cubes.first.z, cubes.end.z) : 0u;
}

// Edges of a column that the surface cuts: bits 0 to 8 run along x, 9 to 17 along y, 18 to 26 along z.
uint CutEdges(BlockCubes cubes, uint column)
{
    const int2 at = ColumnAt(column);
    const uint used = UsedSamples(cubes, at);
    const uint own = inside[column];
    uint cut = ((own ^ (own >> 1)) & used & (used >> 1)) << 18;
    if (at.x < cubes.end.x)
        cut |= (own ^ inside[column + 1u]) & used;
    if (at.y < cubes.end.y)
        cut |= ((own ^ inside[column + BLOCK_SIDE]) & used) << 9;
    return cut;
}

// Edges with lower numbers than the one along an axis at height z, among those that CutEdges names.
uint EdgesBefore(uint axis, int z)
{
    return (1u << (axis * 9u + uint(z))) - 1u;
}

// Cubes of a column that the surface cuts, a bit each.
uint CutCubes(BlockCubes cubes, uint column)
{
    const int2 at = ColumnAt(column);
    const uint used = UsedSamples(cubes, at) & UsedSamples(cubes, at + 1);
    uint cut = 0u;
    if (used != 0u)
    {
        const uint4 corners = uint4(inside[column], inside[column + 1u], inside[column + BLOCK_SIDE], inside[column + BLOCK_SIDE + 1u]);
        const uint full = corners.x & corners.y & corners.z & corners.w;
        const uint reached = corners.x | corners.y | corners.z | corners.w;
        cut = (reached | (reached >> 1)) & ~(full & (full >> 1)) & used & (used >> 1);
    }
    return cut;
}

// The case of marching cubes, MCCubeIndex: a bit a corner outside.
uint CubeCase(uint column, uint z)
{
    const uint4 corners = uint4(inside[column], inside[column + 1u], inside[column + BLOCK_SIDE + 1u], inside[column + BLOCK_SIDE]) >> z;
    const uint4 lower = (corners & 1u) << uint4(0u, 1u, 2u, 3u);
    const uint4 upper = (corners >> 1 & 1u) << uint4(4u, 5u, 6u, 7u);
    const uint4 both = lower | upper;
    return 255u ^ (both.x | both.y | both.z | both.w);
}

#endif
