#ifndef SPHFLUID_CELL_TYPES
#define SPHFLUID_CELL_TYPES

// Threads of a group that walks over neighbours: small groups spread few particles over many processors.
#define CELL_THREADS 64

// Threads of a group of the scan, cells that a thread sums, and parts of a group's sum; mirrored by CellRows.cs.
#define SCAN_THREADS 256
#define SCAN_CELLS_PER_THREAD 8
#define SCAN_SUM_PARTS 16
#define SCAN_CELLS_PER_GROUP (SCAN_THREADS * SCAN_CELLS_PER_THREAD)

// Groups a dispatch may have in one dimension (Direct3D 11, Vulkan, Metal).
#define CELL_MAX_GROUPS 65535

// Particle of a thread: positions and velocities lie in float4 apart, one aligned load each; a velocity's w is the id.
uint ParticleIndex(uint3 groupId, uint groupIndex)
{
    return (groupId.y * CELL_MAX_GROUPS + groupId.x) * CELL_THREADS + groupIndex;
}

#endif
