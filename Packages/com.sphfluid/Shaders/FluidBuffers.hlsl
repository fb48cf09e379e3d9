// A running liquid as kernels and shaders of others read it: include "Packages/com.sphfluid/Shaders/FluidBuffers.hlsl" and set it by
// FluidBuffers.Bind. Simulation space: metres from the centre of the domain box, along its axes; FluidToWorld and FluidFromWorld convert.
// All names begin with Fluid or _Fluid, so that they do not clash with yours. The buffers are to be read only.
#ifndef SPHFLUID_FLUID_BUFFERS
#define SPHFLUID_FLUID_BUFFERS

#include "GridCells.hlsl"

// Mirrored by FluidParticle.cs; 48 bytes.
struct FluidParticle
{
    float3 Position; // m
    uint Id;         // stays with the particle; its place in the buffer does not
    float3 Velocity; // m/s, half a step old
    float Removed;   // 1: nothing is here, the rest is 0
    float3 VelocityAtForce; // m/s, a step old with the thesis's method, otherwise the same
    float Unused;
};

StructuredBuffer<FluidParticle> _FluidParticles; // live ones first, sorted by cell
StructuredBuffer<uint2> _FluidCells;             // [first, end) of each cell's particles: ask FluidParticlesOfCell
StructuredBuffer<float> _FluidDensities;         // kg/m^3, in the order of the particles
StructuredBuffer<float> _FluidPressures;         // Pa, in the order of the particles
uint _FluidParticleCount;   // entries of _FluidParticles to look at, 1 or more, some removed
float _FluidSpacing;        // m, of particles at rest
float _FluidSupportRadius;  // m, of the kernel; a cell is no narrower
float _FluidParticleMass;   // kg
float _FluidRestDensity;    // kg/m^3
float3 _FluidGridOrigin;    // m, lower corner of the domain
float3 _FluidCellSize;      // m
float3 _FluidCellCounts;    // whole numbers
float3 _FluidPeriod;        // m, of axes whose two faces are one; 0: none
float4x4 _FluidSimulationToWorld;
float4x4 _FluidWorldToSimulation;

bool FluidIsAlive(FluidParticle particle)
{
    return particle.Removed == 0.0;
}

float3 FluidToWorld(float3 position)
{
    return mul(_FluidSimulationToWorld, float4(position, 1.0)).xyz;
}

float3 FluidFromWorld(float3 position)
{
    return mul(_FluidWorldToSimulation, float4(position, 1.0)).xyz;
}

float3 FluidDirectionToWorld(float3 direction)
{
    return mul((float3x3)_FluidSimulationToWorld, direction);
}

float3 FluidDirectionFromWorld(float3 direction)
{
    return mul((float3x3)_FluidWorldToSimulation, direction);
}

// From the second position to the first, from its nearest image along periodic axes.
float3 FluidSeparation(float3 position, float3 from)
{
    const float3 d = position - from;
    return d - (_FluidPeriod > 0.0 ? _FluidPeriod * round(d / max(_FluidPeriod, 1e-30)) : float3(0.0, 0.0, 0.0));
}

SPHFLUID_CELL_RANGE(FluidRangeOfCell, _FluidCells)

// Particles of a cell, [first, end).
uint2 FluidParticlesOfCell(int3 cell)
{
    return FluidRangeOfCell(cell, int3(_FluidCellCounts));
}

// Cells that a ball touches: a box of them, which may go on at the opposite face of a periodic axis.
struct FluidCellBox
{
    int3 First;
    int3 Counts;
    uint Count;
};

FluidCellBox FluidCellsAround(float3 position, float radius)
{
    const int3 cells = int3(_FluidCellCounts);
    const float3 low = floor((position - radius - _FluidGridOrigin) / _FluidCellSize);
    const float3 high = floor((position + radius - _FluidGridOrigin) / _FluidCellSize);
    const float3 last = _FluidCellCounts - 1.0;
    const int3 first = int3(_FluidPeriod > 0.0 ? low : clamp(low, 0.0, last));
    const int3 end = int3(_FluidPeriod > 0.0 ? high : clamp(high, 0.0, last));
    FluidCellBox box;
    box.First = first;
    box.Counts = clamp(end - first + 1, int3(1, 1, 1), cells); // no cell twice
    box.Count = uint(box.Counts.x) * uint(box.Counts.y) * uint(box.Counts.z);
    return box;
}

// Particles of the k-th cell.
uint2 FluidCellRange(FluidCellBox box, uint k)
{
    const uint3 counts = uint3(box.Counts);
    const float3 cell = float3(box.First + int3(uint3(k % counts.x, k / counts.x % counts.y, k / (counts.x * counts.y))));
    const float3 wrapped = clamp(cell - _FluidCellCounts * floor((cell + 0.5) / _FluidCellCounts), 0.0, _FluidCellCounts - 1.0);
    return FluidParticlesOfCell(int3(wrapped));
}

// Every particle j of the cells that a ball of any radius touches, one at its centre too; all are alive. Whether j is within the radius is
// the body's question: dot(d, d) < radius * radius, with d = FluidSeparation(position, _FluidParticles[j].Position). Two loops of a
// function need two names j.
#define FOR_EACH_FLUID_PARTICLE_NEAR(position, radius, j) \
    for (uint j##Cell = 0u; j##Cell < FluidCellsAround(position, radius).Count; j##Cell++) \
        for (uint2 j##Range = FluidCellRange(FluidCellsAround(position, radius), j##Cell); j##Range.x < j##Range.y; \
            j##Range.x = j##Range.y) \
            for (uint j = j##Range.x; j < j##Range.y; j++)

#endif
