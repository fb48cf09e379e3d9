#ifndef SPHFLUID_SPRAY_PARTICLE
#define SPHFLUID_SPRAY_PARTICLE

// A particle that left the surface, as the drawing reads it; 32 bytes, simulation space, SI.
struct SprayParticle
{
    float3 position;
    float spray;     // 0 to 1: how much of it is drawn as drops
    float3 velocity;
    uint id;
};

#endif
