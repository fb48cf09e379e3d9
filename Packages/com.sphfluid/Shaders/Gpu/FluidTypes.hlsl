#ifndef SPHFLUID_FLUID_TYPES
#define SPHFLUID_FLUID_TYPES

// Threads of a particle kernel. The thesis prints 2014, a slip for 1024, Direct3D 11's maximum; 256 is allowed everywhere.
#define NUMBER_THREADS 256

// Groups a dispatch may have in one dimension (Direct3D 11, Vulkan, Metal).
#define MAX_GROUPS 65535

// Mirrored by FluidParticle.cs; 48 bytes, simulation space, SI.
struct Particle
{
    float3 Position;
    uint Id;
    float3 VelT0; // velocity half a step after the last force
    float Removed; // 1: no particle, the rest is 0
    float3 VelT1; // velocity at the time of the last force
    float DensityOffset; // what the gradient correction adds to the density, kg/m^3
};

// Index of a thread in a one-dimensional dispatch that continues in y after MAX_GROUPS groups:
// group (3, 1) is group 65538.
uint FlatIndex(uint3 groupId, uint groupIndex)
{
    return (groupId.y * MAX_GROUPS + groupId.x) * NUMBER_THREADS + groupIndex;
}

// Groups x, y, z of such a dispatch, for indirect arguments: 65,538 groups are 65,535 x 2.
uint3 DispatchGroups(uint count)
{
    return uint3(min(count, uint(MAX_GROUPS)), (count + MAX_GROUPS - 1u) / MAX_GROUPS, 1u);
}

#endif
