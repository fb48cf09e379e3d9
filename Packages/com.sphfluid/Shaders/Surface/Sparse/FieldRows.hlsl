#ifndef SPHFLUID_FIELD_ROWS
#define SPHFLUID_FIELD_ROWS

// Sums over the particles at a row of ROW_SAMPLES samples along x, in registers: a particle is read once a row, and no
// thread writes where another does. A kernel that includes this file defines FLUID_PERIODIC.
#include "../../Solver/FluidGrid.hlsl"
#include "../../Solver/PeriodicAxes.hlsl"
#include "../SurfaceGrid.hlsl"
#include "SurfaceParticles.hlsl"

StructuredBuffer<float4> _SurfaceParticles;
#if defined(SURFACE_ANISOTROPIC)
StructuredBuffer<KernelShape> _SurfaceShapes;
#endif
StructuredBuffer<uint2> _GridIndices; // [first, end) of each cell of the fluid grid
float _FieldReach;                    // m: how far from a sample the particles that it feels may lie
float3 _PeriodSteps;                  // length of the domain in R along periodic axes

// Fluid cells that particles in reach of the samples from first to last may be in. Particles beyond a wall are in the
// outermost cells.
int2 CellsInReach(float first, float last, float origin, float cell, int count, float reach, float period)
{
    const int2 cells = int2(floor((first - reach - origin) / cell), floor((last + reach - origin) / cell));
    return period == 0.0 ? clamp(cells, 0, count - 1) : cells;
}

// Whether no particle of a row of cells reaches a row of samples, both along x. The margin takes rounding.
bool IsBeyond(float2 cell, float2 samples)
{
    const float2 low = _GridOrigin.yz + _CellSize.yz * cell;
    const float2 d = max(max(low - samples, samples - low - _CellSize.yz), 0.0);
    return dot(d, d) > _FieldReach * _FieldReach * 1.001;
}

// Adds what the particles of a run give to a row of samples. Along the row d . M d is left + x (tilt + x stretch).
void AddRun(uint2 run, float3 image, int3 first, inout float row[ROW_SAMPLES])
{
    precise const float2 across = _FieldStep.yz * float2(first.yz);
    for (uint j = run.x; j < run.y; j++)
    {
        const float4 particle = _SurfaceParticles[j];
        precise const float3 centre = particle.xyz + image;
        precise const float2 d = centre.yz - across;
#if defined(SURFACE_ANISOTROPIC)
        const KernelShape shape = _SurfaceShapes[j];
        precise const float left = 1.0 - d.x * d.x * shape.Diagonal.y - d.y * d.y * shape.Diagonal.z - 2.0 * d.x * d.y * shape.Mixed.z;
        precise const float tilt = 2.0 * (d.x * shape.Mixed.x + d.y * shape.Mixed.y);
        precise const float stretch = shape.Diagonal.x;
        const bool reaches = left * stretch > -0.25 * tilt * tilt;
#else
        precise const float left = 1.0 - d.x * d.x - d.y * d.y;
        const bool reaches = left > 0.0;
#endif
        if (reaches)
        {
            [unroll]
            for (int x = 0; x < ROW_SAMPLES; x++)
            {
                precise const float along = centre.x - _FieldStep.x * float(first.x + x);
#if defined(SURFACE_ANISOTROPIC)
                precise const float t = max(left - along * (tilt + along * stretch), 0.0);
#else
                precise const float t = max(left - along * along, 0.0);
#endif
                precise const float sum = row[x] + particle.w * (t * t * t);
                row[x] = sum;
            }
        }
    }
}

// Particles of the cells from first to last of a row: one run, as cells of a row follow each other.
uint2 RunOf(int first, int last, int y, int z)
{
    uint2 run = uint2(0xffffffffu, 0u);
    const uint row = CellIndex(int3(0, y, z));
    for (int x = first; x <= last; x++)
    {
        const uint2 cell = _GridIndices[row + uint(x)];
        run.x = cell.x < cell.y ? min(run.x, cell.x) : run.x; // an empty cell is [0, 0)
        run.y = max(run.y, cell.y);
    }
    return run;
}

// How often a cell of an endless row has gone round a periodic axis: of 5 cells, -1 has -1, 4 has 0, 5 has 1. From the
// middle of the cell, so that no rounding matters.
int Turn(int cell, int count)
{
    return int(floor((float(cell) + 0.5) / float(count)));
}

// Sums of a row of samples that begins at first. The order of the particles, and so the last bit of a sum, depends on
// the place of the sample alone: blocks that share a sample may find more particles, but those add exact zeros.
void SumRow(int3 first, inout float row[ROW_SAMPLES])
{
    const float3 from = _MCMinimum + _MCCellSize * float3(first);
    const float to = _MCMinimum.x + _MCCellSize.x * float(first.x + ROW_SAMPLES - 1);
    const int2 xs = CellsInReach(from.x, to, _GridOrigin.x, _CellSize.x, _GridCounts.x, _FieldReach, _PeriodLength.x);
    const int2 ys = CellsInReach(from.y, from.y, _GridOrigin.y, _CellSize.y, _GridCounts.y, _FieldReach, _PeriodLength.y);
    const int2 zs = CellsInReach(from.z, from.z, _GridOrigin.z, _CellSize.z, _GridCounts.z, _FieldReach, _PeriodLength.z);
    const int firstTurn = Turn(xs.x, _GridCounts.x);
    const int lastTurn = Turn(xs.y, _GridCounts.x);
    // In one loop over turns along x and rows of cells along y and z: three in each other take FXC a third of a second
    // more.
    int3 at = int3(firstTurn, ys.x, zs.x);
    while (at.z <= zs.y)
    {
        const int2 turn = int2(Turn(at.y, _GridCounts.y), Turn(at.z, _GridCounts.z));
        const int2 wrapped = at.yz - turn * _GridCounts.yz;
        const int offset = at.x * _GridCounts.x;
        uint2 run = 0u;
        if (!IsBeyond(float2(at.yz), from.yz))
        {
            run = RunOf(max(xs.x - offset, 0), min(xs.y - offset, _GridCounts.x - 1), wrapped.x, wrapped.y);
        }
        AddRun(run, _PeriodSteps * float3(at.x, turn), first, row);
        at.x++;
        if (at.x > lastTurn)
        {
            at.xy = int2(firstTurn, at.y + 1);
        }
        if (at.y > ys.y)
        {
            at.yz = int2(ys.x, at.z + 1);
        }
    }
}

#endif
