#ifndef SPHFLUID_OFFSET_BITS
#define SPHFLUID_OFFSET_BITS

// The lowest bits of an offset, which say something of its particle in this step alone.
#define OFFSET_STARTS 1u // it was not known before: the density has not grown by it
#define OFFSET_HIT 2u    // an impact compresses the particle

#endif
