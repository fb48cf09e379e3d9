#ifndef SPHFLUID_OFFSET_START
#define SPHFLUID_OFFSET_START

#define OFFSET_STARTS 1u // the lowest bit of an offset that was not known before: the density has not grown by it

#endif
