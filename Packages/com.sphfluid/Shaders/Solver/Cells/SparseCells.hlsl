#ifndef SPHFLUID_SPARSE_CELLS
#define SPHFLUID_SPARSE_CELLS

// The table of the cells where only those with particles are stored: bits say which they are, and the number of bits before one where it
// is stored. 32 cells that follow each other in the order of the cells are a strip, 32 strips a word. The table is
//   0 to 7   words there are: 0 in a table of all cells, whose first begins with particle 0; live particles; those with whoever left
//            in the last step; those born since the sort; strips with particles; cells with particles; two that are free
//   words    two numbers each: which strips have particles; how many strips do before
//   entries  four numbers each: which cells of a strip have particles, and how many cells do before; the first particle of a cell,
//            and the number of the cell. Strips and cells are numbered apart, and there is an entry more than particles.
// Worked example: particles 0 and 1 in cell 3, 2 in cell 40, 3 in cell 2,000. Strips 0, 1 and 62 are stored as 0, 1, 2 and the cells as
// 0, 1, 2; cell 35 is empty and begins where cell 40 does: strip 1 has one cell before it, and none of its own before the 35th.
// Filled by RankCells.compute; mirrored by SparseCells.cs. Whoever includes this file defines CELL_TABLE.
#define SPARSE_WORDS 0u
#define SPARSE_LIVE 1u
#define SPARSE_COUNTED 2u
#define SPARSE_BORN 3u
#define SPARSE_STRIPS 4u
#define SPARSE_CELLS 5u
#define SPARSE_HEAD 8u
#define SPARSE_ENTRY 2u // four numbers, as a shift
#define SPARSE_START 2u  // in an entry
#define SPARSE_NUMBER 3u

// Bits below one of a word.
uint BitsBefore(uint bit)
{
    return (1u << bit) - 1u;
}

uint SparseEntry(uint words, uint number)
{
    return SPARSE_HEAD + 2u * words + (number << SPARSE_ENTRY);
}

// Where a strip is stored, or the next that is. Whether it is itself: the bit.
uint SparseStrip(uint cell, out uint bit)
{
    const uint word = SPARSE_HEAD + 2u * (cell >> 10u);
    const uint strips = CELL_TABLE[word];
    const uint strip = (cell >> 5u) & 31u;
    bit = (strips >> strip) & 1u;
    return CELL_TABLE[word + 1u] + countbits(strips & BitsBefore(strip));
}

// Where a cell is stored, or the next that is.
uint SparseCell(uint words, uint cell)
{
    uint bit;
    const uint entry = SparseEntry(words, SparseStrip(cell, bit));
    return CELL_TABLE[entry + 1u] + bit * countbits(CELL_TABLE[entry] & BitsBefore(cell & 31u));
}

uint SparseStart(uint words, uint cell)
{
    return CELL_TABLE[SparseEntry(words, SparseCell(words, cell)) + SPARSE_START];
}

#endif
