#ifndef SPHFLUID_GRID_CELLS
#define SPHFLUID_GRID_CELLS

// Particles of a cell of the published grid, [first, end); first is end where there are none. The buffer has a range for each cell, x
// first, then y, then z: the first begins with particle 0. Where the domain has too many cells it has those with particles only
// (Solver/Cells/SparseCells.hlsl, PublishRanks in Solver/Cells/RankCells.compute), and as its first element
//   x   words: the elements that come next. Each has a bit for a strip of 32 cells, numbered with a border of one, and how many come
//       before them; behind them stand as many elements with a bit for each cell of a strip, and again how many come before
//   y   where the ranges of these cells begin
// name: of the function; cells: the buffer.
#define SPHFLUID_CELL_RANGE(name, cells) \
uint2 name(int3 cell, int3 counts) \
{ \
    const uint2 head = cells[0]; \
    uint2 range; \
    [branch] \
    if (head.x == 0u) \
    { \
        range = cells[uint(cell.x + counts.x * (cell.y + counts.y * cell.z))]; \
    } \
    else \
    { \
        const uint number = uint(cell.x + 1 + (counts.x + 2) * (cell.y + 1 + (counts.y + 2) * (cell.z + 1))); \
        const uint strip = (number >> 5u) & 31u; \
        const uint bit = number & 31u; \
        const uint2 strips = cells[1u + (number >> 10u)]; \
        const uint stored = (strips.x >> strip) & 1u; \
        const uint2 own = cells[1u + head.x + strips.y + countbits(strips.x & ((1u << strip) - 1u))]; \
        range = cells[head.y + own.y + stored * countbits(own.x & ((1u << bit) - 1u))]; \
        range.y = (stored & (own.x >> bit)) != 0u ? range.y : range.x; \
    } \
    return range; \
}

#endif
