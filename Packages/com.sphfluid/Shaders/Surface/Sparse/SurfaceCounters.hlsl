#ifndef SPHFLUID_SURFACE_COUNTERS
#define SPHFLUID_SURFACE_COUNTERS

// Slots of _SurfaceCounters, mirrored by SurfaceCounters.cs.
#define SURFACE_BLOCKS_WANTED 0u  // blocks that want a slot, those of the late round included
#define SURFACE_BLOCKS_LISTED 1u  // blocks of the first round; 0 where not all fit
#define SURFACE_BLOCKS_LATE 2u    // blocks of the late round
#define SURFACE_ROUND_FIRST 3u    // first slot of the present round
#define SURFACE_ROUND_COUNT 4u    // slots of the present round
#define SURFACE_VERTICES_WANTED 5u
#define SURFACE_INDICES_WANTED 6u
#define SURFACE_OPEN_FACES 7u
#define SURFACE_NON_FINITE 8u     // particles passed over: their position is not a number
#define SURFACE_COMPLETE 9u       // 1 where the surface fitted the buffers and was emitted
#define SURFACE_COUNTERS 16u

#endif
