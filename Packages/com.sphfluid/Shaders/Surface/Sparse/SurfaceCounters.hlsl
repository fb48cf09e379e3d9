#ifndef SPHFLUID_SURFACE_COUNTERS
#define SPHFLUID_SURFACE_COUNTERS

// Slots of _SurfaceCounters, mirrored by SurfaceCounters in SurfaceBlocks.cs.
#define SURFACE_BLOCKS_REQUESTED 0u   // blocks that need a slot, those of the late round included
#define SURFACE_BLOCKS_LISTED 1u      // blocks of the first round; 0 where not all fit
#define SURFACE_BLOCKS_LATE 2u        // blocks of the late round
#define SURFACE_ROUND_FIRST 3u        // first slot of the present round
#define SURFACE_ROUND_COUNT 4u        // slots of the present round
#define SURFACE_VERTICES_REQUESTED 5u // vertices of all listed blocks
#define SURFACE_INDICES_REQUESTED 6u  // indices of all listed blocks
#define SURFACE_OPEN_FACES 7u         // faces that the surface crosses towards a block without a slot, after the late round
#define SURFACE_NON_FINITE 8u         // particles that are skipped: their position is not a number
#define SURFACE_COMPLETE 9u           // 1 where the surface fitted the buffers and was emitted
#define SURFACE_NUMBER 10u            // number of the recording
#define SURFACE_COUNTERS 16u

#endif
