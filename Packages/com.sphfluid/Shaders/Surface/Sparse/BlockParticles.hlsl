#ifndef SPHFLUID_BLOCK_PARTICLES
#define SPHFLUID_BLOCK_PARTICLES

// The particles that the samples of a block feel, in groupshared memory, LOAD_SIZE at a time, and which patches of
// samples each can reach. Their order depends on places alone: rows of cells by z, y and x, particles of a row by index;
// blocks that share a sample may find more of them, but in the same order.
// Patches are PATCH_SIDE^3 samples. For each axis and each patch along it there is a mask with a bit a loaded particle:
// a patch meets the particles whose bits stand in the masks of all three axes.
// Worked example, 9 samples: particle 5, 1 away from samples 2 to 4 of x at least, sets bit 5 of the patches 0 and 1.
// A kernel that includes this file defines FLUID_PERIODIC, SIDE (samples of the block along an axis), SAMPLE_THREADS and
// VALUE_WORDS (how much of the groupshared memory it uses itself, afterwards).
#include "../../Solver/FluidGrid.hlsl"
#include "../../GridCells.hlsl"
#include "../../Solver/DomainFaces.hlsl"
#include "../SurfaceGrid.hlsl"
#include "SurfaceParticles.hlsl"

#define PATCH_SIDE 3
#define PATCHES ((SIDE + PATCH_SIDE - 1) / PATCH_SIDE) // along an axis
#define PATCH_COUNT uint(PATCHES * PATCHES * PATCHES)

#define LOAD_SIZE 128
#define LOAD_WORDS (LOAD_SIZE / 32)

#if defined(SURFACE_ANISOTROPIC)
#define KERNELS 1
#else
#define KERNELS 2 // of a particle that is stretched: the first has its weight below 0, the second's place is LOAD_SIZE behind
#endif

// Groupshared memory, in words: kernels of loaded particles (centre, image of a periodic one included, and weight), masks of two
// loads (one is used, the other is cleared) and the rows of cells that particles are taken from: index of a row's first
// particle less its number, rounds (see PackTurns), end of its numbers. What a kernel does afterwards may use it again.
#define LOADED_AT 0
#define MASKS_AT (LOADED_AT + 4 * KERNELS * LOAD_SIZE)
#define LOAD_MASKS (3 * PATCHES * LOAD_WORDS)
#define ROW_CLUSTER 8
#define ROW_FIRSTS_AT (MASKS_AT + 2 * LOAD_MASKS)
#define ROW_TURNS_AT (ROW_FIRSTS_AT + SAMPLE_THREADS)
#define ROW_ENDS_AT (ROW_TURNS_AT + SAMPLE_THREADS)
#define CLUSTER_TOTALS_AT (ROW_ENDS_AT + SAMPLE_THREADS)
#define CANDIDATE_WORDS (CLUSTER_TOTALS_AT + SAMPLE_THREADS / ROW_CLUSTER)
#if defined(SURFACE_ANISOTROPIC)
#define LOADED_INDICES_AT CANDIDATE_WORDS
#define PARTICLE_WORDS (LOADED_INDICES_AT + LOAD_SIZE)
#else
#define PARTICLE_WORDS CANDIDATE_WORDS
#endif
#if VALUE_WORDS > PARTICLE_WORDS
#define POOL_WORDS VALUE_WORDS
#else
#define POOL_WORDS PARTICLE_WORDS
#endif
groupshared uint pool[POOL_WORDS];

StructuredBuffer<float4> _SurfaceParticles;
#if !defined(SURFACE_ANISOTROPIC)
StructuredBuffer<uint2> _Spray;       // y: stretch
float _LongestStretch;                // in R, along the flow
#endif
StructuredBuffer<uint2> _GridIndices; // [first, end) of each cell of the fluid grid: GridCells.hlsl
float _FieldReach;                    // m: how far from a sample the particles that it feels may lie
float _KernelExtent;                  // R: how far kernels reach from their centres
float3 _PeriodSteps;                  // length of the domain in R along periodic axes

SPHFLUID_CELL_RANGE(CellRange, _GridIndices)

// Fluid cells that hold what a block's samples feel.
struct BlockReach
{
    int3 first;
    int3 last;
    int2 turns;  // first and last round along a periodic x axis
    float2 from; // m: y and z of the first and
    float2 to;   // the last samples
};

// Which patches of a block a kernel reaches: at c, in R, those from c rate - low, rounded up, to c rate + high, rounded
// down.
struct PatchReach
{
    float3 rate;
    float3 low;
    float3 high;
};

// Fluid cells that particles in reach of the samples from first to last may be in. Particles beyond a wall are in the
// outermost cells.
int2 CellsInReach(float first, float last, float origin, float cell, int count, float reach, float period)
{
    const int2 cells = int2(floor((first - reach - origin) / cell), floor((last + reach - origin) / cell));
    return period == 0.0 ? clamp(cells, 0, count - 1) : cells;
}

// How often a cell of an endless row has gone round a periodic axis: of 5 cells, -1 has -1, 4 has 0, 5 has 1. From the
// middle of the cell, so that no rounding matters.
int Turn(int cell, int count)
{
    return int(floor((float(cell) + 0.5) / float(count)));
}

BlockReach ReachOf(int3 first)
{
    const float3 from = _MCMinimum + _MCCellSize * float3(first);
    const float3 to = _MCMinimum + _MCCellSize * float3(first + (SIDE - 1));
    const int2 xs = CellsInReach(from.x, to.x, _GridOrigin.x, _CellSize.x, _GridCounts.x, _FieldReach, _PeriodLength.x);
    const int2 ys = CellsInReach(from.y, to.y, _GridOrigin.y, _CellSize.y, _GridCounts.y, _FieldReach, _PeriodLength.y);
    const int2 zs = CellsInReach(from.z, to.z, _GridOrigin.z, _CellSize.z, _GridCounts.z, _FieldReach, _PeriodLength.z);
    BlockReach reach;
    reach.first = int3(xs.x, ys.x, zs.x);
    reach.last = int3(xs.y, ys.y, zs.y);
    reach.turns = int2(Turn(xs.x, _GridCounts.x), Turn(xs.y, _GridCounts.x));
    reach.from = from.yz;
    reach.to = to.yz;
    return reach;
}

PatchReach PatchesOf(int3 first)
{
    const float3 extent = (_KernelExtent / _FieldStep + 0.01) / float(PATCH_SIDE); // the margin, in samples, takes rounding
    const float3 start = float3(first) / float(PATCH_SIDE);
    PatchReach reach;
    reach.rate = 1.0 / (float(PATCH_SIDE) * _FieldStep);
    reach.low = start + extent + float(PATCH_SIDE - 1) / float(PATCH_SIDE);
    reach.high = extent - start;
    return reach;
}

// Rows of cells along x; a row has a part for each round.
uint RowCount(BlockReach reach)
{
    const int3 counts = reach.last - reach.first + 1;
    return uint((reach.turns.y - reach.turns.x + 1) * counts.y * counts.z);
}

// Round along x, and y and z of the cells of a row.
int3 RowAt(BlockReach reach, uint row)
{
    const uint turns = uint(reach.turns.y - reach.turns.x + 1);
    const uint strip = row / turns;
    const uint layer = strip / uint(reach.last.y - reach.first.y + 1);
    return int3(reach.turns.x, reach.first.yz) +
        int3(row - strip * turns, strip - layer * uint(reach.last.y - reach.first.y + 1), layer);
}

// Whether no particle of a row of cells reaches the samples of the block. The margin takes rounding.
bool IsBeyond(BlockReach reach, float2 cell)
{
    const float2 low = _GridOrigin.yz + _CellSize.yz * cell;
    const float2 d = max(max(low - reach.to, reach.from - low - _CellSize.yz), 0.0);
    return dot(d, d) > _FieldReach * _FieldReach * 1.001;
}

// Rounds of a row along each axis, a byte each.
uint PackTurns(int3 turns)
{
    const uint3 bytes = uint3(turns + 128);
    return bytes.x | (bytes.y << 8) | (bytes.z << 16);
}

float3 UnpackTurns(uint packed)
{
    return float3(int3(uint3(packed, packed >> 8, packed >> 16) & 255u) - 128);
}

// Particles of a row: one run, as its cells follow each other.
uint2 RunOf(BlockReach reach, int3 at)
{
    const int2 wrapped = at.yz - int2(Turn(at.y, _GridCounts.y), Turn(at.z, _GridCounts.z)) * _GridCounts.yz;
    const int first = max(reach.first.x - at.x * _GridCounts.x, 0);
    int end = min(reach.last.x - at.x * _GridCounts.x, _GridCounts.x - 1) + 1;
    end = IsBeyond(reach, float2(at.yz)) ? first : end;
    uint2 run = uint2(0xffffffffu, 0u);
    for (int x = first; x < end; x++)
    {
        const uint2 cell = CellRange(int3(x, wrapped), _GridCounts);
        run.x = cell.x < cell.y ? min(run.x, cell.x) : run.x; // an empty cell has no first
        run.y = max(run.y, cell.y);
    }
    return run.x < run.y ? run : uint2(0u, 0u);
}

// Takes the next rows of cells, one a thread: candidates, the particles of these rows, are numbered through. Each row
// then has the end of its numbers, and the index of its first particle less that particle's number. Begins and ends with
// barriers. first: first sample of the block. Returns how many candidates there are, and how many rows in all.
uint2 TakeRows(int3 first, uint firstRow, uint thread)
{
    const BlockReach reach = ReachOf(first);
    const uint rows = RowCount(reach);
    GroupMemoryBarrierWithGroupSync();
    uint2 run = uint2(0u, 0u);
    uint turns = 0u;
    for (uint row = firstRow + thread; row < rows; row += rows) // at most once
    {
        const int3 at = RowAt(reach, row);
        run = RunOf(reach, at);
        turns = PackTurns(int3(at.x, Turn(at.y, _GridCounts.y), Turn(at.z, _GridCounts.z)));
    }
    const uint cluster = thread / ROW_CLUSTER;
    pool[ROW_ENDS_AT + thread] = run.y - run.x;
    GroupMemoryBarrierWithGroupSync();
    uint number = 0u;
    for (uint before = cluster * ROW_CLUSTER; before < thread; before++)
    {
        number += pool[ROW_ENDS_AT + before];
    }
    if (thread % ROW_CLUSTER == ROW_CLUSTER - 1u)
    {
        pool[CLUSTER_TOTALS_AT + cluster] = number + run.y - run.x;
    }
    GroupMemoryBarrierWithGroupSync();
    for (uint earlier = 0u; earlier < cluster; earlier++)
    {
        number += pool[CLUSTER_TOTALS_AT + earlier];
    }
    pool[ROW_FIRSTS_AT + thread] = run.x - number;
    pool[ROW_TURNS_AT + thread] = turns;
    pool[ROW_ENDS_AT + thread] = number + run.y - run.x;
    GroupMemoryBarrierWithGroupSync();
    const uint count = pool[ROW_ENDS_AT + SAMPLE_THREADS - 1];
    GroupMemoryBarrierWithGroupSync();
    return uint2(count, rows);
}

uint MasksAt(uint load)
{
    return MASKS_AT + load % 2u * LOAD_MASKS;
}

void ClearMasks(uint load, uint thread)
{
    for (uint word = thread; word < LOAD_MASKS; word += SAMPLE_THREADS)
    {
        pool[MasksAt(load) + word] = 0u;
    }
}

void StoreKernel(uint place, float3 centre, float weight)
{
    const uint4 words = asuint(float4(centre, weight));
    const uint at = LOADED_AT + 4u * place;
    pool[at] = words.x;
    pool[at + 1u] = words.y;
    pool[at + 2u] = words.z;
    pool[at + 3u] = words.w;
}

// Loads a particle for the patches that it reaches, if any.
void LoadParticle(PatchReach reach, uint j, uint turns, uint load, uint place)
{
    const float4 particle = _SurfaceParticles[j];
    precise const float3 centre = particle.xyz + _PeriodSteps * UnpackTurns(turns);
    const float3 patch = centre * reach.rate;
    float3 apart = 0.0;
#if !defined(SURFACE_ANISOTROPIC)
    [branch]
    if (particle.w < 0.0)
    {
        apart = abs(UnpackStretch(_Spray[j].y)) * (_LongestStretch * reach.rate);
    }
#endif
    const int3 lower = int3(ceil(max(patch - apart - reach.low, 0.0)));
    const int3 end = int3(floor(min(patch + apart + reach.high, float(PATCHES - 1)))) + 1;
    const int3 reached = particle.w != 0.0 ? end - lower : 0;
    if (min(reached.x, min(reached.y, reached.z)) > 0)
    {
        const uint bit = 1u << (place % 32u);
        const uint masks = MasksAt(load) + place / 32u;
        for (int x = lower.x; x < end.x; x++)
        {
            InterlockedOr(pool[masks + uint(x) * LOAD_WORDS], bit);
        }
        for (int y = lower.y; y < end.y; y++)
        {
            InterlockedOr(pool[masks + uint(PATCHES + y) * LOAD_WORDS], bit);
        }
        for (int z = lower.z; z < end.z; z++)
        {
            InterlockedOr(pool[masks + uint(2 * PATCHES + z) * LOAD_WORDS], bit);
        }
        StoreKernel(place, centre, particle.w);
#if defined(SURFACE_ANISOTROPIC)
        pool[LOADED_INDICES_AT + place] = j;
#else
        [branch]
        if (particle.w < 0.0)
        {
            const float3 stretch = UnpackStretch(_Spray[j].y);
            precise const float3 first = centre + _LongestStretch * stretch;
            precise const float3 second = centre - _LongestStretch * stretch;
            StoreKernel(place, first, particle.w);
            StoreKernel(place + LOAD_SIZE, second, -particle.w);
        }
#endif
    }
}

// Loads the candidates from first on, as far as there are. row: the caller's, 0 at first. Barriers before and after are
// the caller's.
void LoadCandidates(PatchReach reach, uint first, uint count, uint load, uint thread, inout uint row)
{
    const uint end = min(count - first, LOAD_SIZE);
    for (uint place = thread; place < end; place += SAMPLE_THREADS)
    {
        while (first + place >= pool[ROW_ENDS_AT + row])
        {
            row++;
        }
        LoadParticle(reach, pool[ROW_FIRSTS_AT + row] + first + place, pool[ROW_TURNS_AT + row], load, place);
    }
}

float4 LoadedKernel(uint place)
{
    const uint at = LOADED_AT + 4u * place;
    return asfloat(uint4(pool[at], pool[at + 1u], pool[at + 2u], pool[at + 3u]));
}

// Place of a patch among the block's.
int3 PatchAt(uint patch)
{
    return int3(patch % PATCHES, patch / PATCHES % PATCHES, patch / (PATCHES * PATCHES));
}

// Loaded particles that can reach a patch.
uint4 MaskOf(uint load, int3 patch)
{
    const uint x = MasksAt(load) + uint(patch.x) * LOAD_WORDS;
    const uint y = MasksAt(load) + uint(PATCHES + patch.y) * LOAD_WORDS;
    const uint z = MasksAt(load) + uint(2 * PATCHES + patch.z) * LOAD_WORDS;
    return uint4(pool[x] & pool[y] & pool[z], pool[x + 1u] & pool[y + 1u] & pool[z + 1u],
        pool[x + 2u] & pool[y + 2u] & pool[z + 2u], pool[x + 3u] & pool[y + 3u] & pool[z + 3u]);
}

// Of a mask the first word with a bit, and what that word holds. Worked example: of (0, 12, 0, 1), (1, 12).
uint2 FirstWord(uint4 mask)
{
    const uint word = mask.x != 0u ? 0u : (mask.y != 0u ? 1u : (mask.z != 0u ? 2u : 3u));
    return uint2(word, mask.x != 0u ? mask.x : (mask.y != 0u ? mask.y : (mask.z != 0u ? mask.z : mask.w)));
}

#endif
