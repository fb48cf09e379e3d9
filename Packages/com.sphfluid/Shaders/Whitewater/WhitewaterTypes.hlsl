#ifndef SPHFLUID_WHITEWATER_TYPES
#define SPHFLUID_WHITEWATER_TYPES

// A piece of whitewater: a drop in the air, foam on the surface or a bubble below it; 48 bytes, simulation space, SI.
struct WhitewaterParticle
{
    float3 position;
    float life;    // s that foam has left; at 0 it is gone
    float3 velocity;
    uint seed;     // random, the same all its life; the two lowest bits are its kind
    float3 normal; // out of the liquid; zero where that is not known
    float age;     // s
};

#define WHITEWATER_KIND 3u
#define WHITEWATER_SPRAY 0u
#define WHITEWATER_FOAM 1u
#define WHITEWATER_BUBBLE 2u

uint KindOf(WhitewaterParticle particle)
{
    return particle.seed & WHITEWATER_KIND;
}

// Slots of _WhitewaterState, mirrored by WhitewaterBuffers.cs.
#define WHITEWATER_COUNT 0     // pieces
#define WHITEWATER_BEFORE 1    // pieces before the list was made anew
#define WHITEWATER_SURVIVORS 2 // of those, how many are not gone
#define WHITEWATER_REQUESTED 3 // births that the liquid asks for in this frame, in 1 / WHITEWATER_UNITS
#define WHITEWATER_BORN 4      // since the start
#define WHITEWATER_REFUSED 5   // since the start: asked for, but there was no place
#define WHITEWATER_LARGEST 6   // three: trapped air, wave crest and energy, the largest of this frame, as bits of floats
#define WHITEWATER_MEANS 9     // three: running means of those, as bits of floats
#define WHITEWATER_TIME 12     // s that the means go over, as bits of a float

// So many parts of a birth add up over a liquid of a million particles, with 16 births each, within 32 bits.
#define WHITEWATER_UNITS 256.0

#endif
