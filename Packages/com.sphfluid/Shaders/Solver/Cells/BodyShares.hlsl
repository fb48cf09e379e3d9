#ifndef SPHFLUID_BODY_SHARES
#define SPHFLUID_BODY_SHARES

#include "CellRows.hlsl"
#include "MeshWalls.hlsl"
#include "../../Collision/BodyImpulses.hlsl"

// What a particle gives in a step to the bodies whose planes it feels. Most groups of threads touch one body: they sum in their own
// memory first, in whole units, and give what is left one by one.
#if defined(FLUID_FLOATING_BODIES)

#define NO_BODY_NUMBER 0xffffffffu

groupshared uint groupBody;
groupshared int groupHigh[6]; // of each sum the upper 16 bits of every thread's units
groupshared int groupLow[6];  // and the lower: 64 threads stay below 2^31

struct BodyShares
{
    uint3 Numbers; // of the planes' bodies, 0 for none
    float3 First;  // N s, what each plane's body gets
    float3 Second;
    float3 Third;
    float3 Place;  // of the particle
};

BodyShares NoShares()
{
    return (BodyShares)0;
}

// changes: what each plane adds to a particle's velocity; its body gets the opposite.
BodyShares SharesOf(uint id, float3 changes[WALL_PLANES], float3 place)
{
    const uint numbers = LISTS[_WallBodiesBegin + id];
    BodyShares shares;
    shares.Numbers = (numbers >> uint3(0u, BODY_NUMBER_BITS, 2u * BODY_NUMBER_BITS)) & BODY_NUMBER_MASK;
    shares.First = -_ParticleMass * changes[0];
    shares.Second = -_ParticleMass * changes[1];
    shares.Third = -_ParticleMass * changes[2];
    shares.Place = place;
    return shares;
}

float3 ShareOf(BodyShares shares, uint number)
{
    return float(shares.Numbers.x == number) * shares.First + float(shares.Numbers.y == number) * shares.Second +
        float(shares.Numbers.z == number) * shares.Third;
}

uint LeastNumber(uint3 numbers)
{
    const uint3 present = numbers == 0u ? uint3(NO_BODY_NUMBER, NO_BODY_NUMBER, NO_BODY_NUMBER) : numbers;
    return min(present.x, min(present.y, present.z));
}

void AddInGroup(uint sum, int units)
{
    InterlockedAdd(groupHigh[sum], units >> 16);
    InterlockedAdd(groupLow[sum], units & 0xffff);
}

void GiveToGroup(BodyShares shares, uint number)
{
    const Units units = UnitsOf(ShareOf(shares, number), ArmOf(number, shares.Place));
    AddInGroup(0u, units.Impulse.x);
    AddInGroup(1u, units.Impulse.y);
    AddInGroup(2u, units.Impulse.z);
    AddInGroup(3u, units.Angular.x);
    AddInGroup(4u, units.Angular.y);
    AddInGroup(5u, units.Angular.z);
}

// To be called by all threads of a group.
void GiveShares(uint thread, BodyShares shares)
{
    if (thread < 6u)
    {
        groupHigh[thread] = 0;
        groupLow[thread] = 0;
    }
    if (thread == 0u)
    {
        groupBody = NO_BODY_NUMBER;
    }
    GroupMemoryBarrierWithGroupSync();
    if (any(shares.Numbers != 0u))
    {
        InterlockedMin(groupBody, LeastNumber(shares.Numbers));
    }
    GroupMemoryBarrierWithGroupSync();
    const uint number = groupBody;
    uint3 left = shares.Numbers;
    [loop]
    for (uint turn = 0u; turn < uint(WALL_PLANES) && any(left != 0u); turn++)
    {
        const uint next = LeastNumber(left);
        if (next == number)
        {
            GiveToGroup(shares, next);
        }
        else
        {
            GiveImpulse(next, ShareOf(shares, next), shares.Place);
        }
        left = left == next ? uint3(0u, 0u, 0u) : left;
    }
    GroupMemoryBarrierWithGroupSync();
    if (thread < 6u && number != NO_BODY_NUMBER)
    {
        const uint shifted = uint(groupHigh[thread]) << 16u;
        const uint low = shifted + uint(groupLow[thread]);
        const uint high = uint(groupHigh[thread] >> 16) + (low < shifted ? 1u : 0u);
        AddWords((number - 1u) * IMPULSE_WORDS + 2u * thread, low, high);
    }
}

#endif

#endif
