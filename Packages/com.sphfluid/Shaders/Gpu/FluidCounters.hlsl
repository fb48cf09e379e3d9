#ifndef SPHFLUID_FLUID_COUNTERS
#define SPHFLUID_FLUID_COUNTERS

// Slots of _Counters, mirrored by CounterReadback.cs.
#define COUNTER_ACCELERATION_LIMIT 0
#define COUNTER_DOMAIN_CLAMP 1
#define COUNTER_NON_FINITE 2
#define COUNTER_SHORTENED 3
#define COUNTER_CONTACT_FALLBACK 4
#define COUNTER_SQUEEZED 5
#define COUNTER_OVERLAP 6
#define COUNTER_CONTACT 7
#define COUNTER_REMOVED 8 // but through a face
#define COUNTER_BORN 9
#define COUNTER_BLOCKED 10
#define COUNTER_REFUSED 11
#define COUNTER_IMPULSE_LIMIT 12
#define COUNTER_LEFT_THROUGH_FACE 13
#define COUNTER_MAX_SPEED 14
#define COUNTER_MAX_DENSITY 15
#define COUNTER_SQUEEZERS 16 // numbers of two bodies in 16 bits each, 0: none

RWStructuredBuffer<uint> _Counters;

void CountEvent(uint slot)
{
    InterlockedAdd(_Counters[slot], 1u);
}

// Non-negative floats order as their bits do, so an integer maximum serves and does not depend on thread timing.
void CountMaximum(uint slot, float value)
{
    if (asuint(value) > _Counters[slot])
    {
        InterlockedMax(_Counters[slot], asuint(value));
    }
}

// By bits: compilers may drop isnan and isinf.
bool IsFinite(float3 v)
{
    return all((asuint(v) & 0x7f800000u) != 0x7f800000u);
}

#endif
