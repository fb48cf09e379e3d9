#ifndef SPHFLUID_BODY_IMPULSES
#define SPHFLUID_BODY_IMPULSES

// Sums of what particles give to bodies, in whole units: the same in any order. A kernel that includes this file declares the
// keyword FLUID_FLOATING_BODIES.

#include "../Gpu/FluidCounters.hlsl"
#include "FloatingBodies.hlsl"

#if defined(FLUID_FLOATING_BODIES)

StructuredBuffer<FloatingState> _FloatingStates;
RWStructuredBuffer<uint> _ImpulseSums;
float _ImpulseUnits; // a N s
float _AngularUnits; // a N m s
float _ParticleMass; // kg

static const float MOST_UNITS = 2147483520.0; // the largest float below 2^31

struct Units
{
    int3 Impulse;
    int3 Angular;
};

// Of a particle's impulse; more than 32 m c, or no number, is counted.
Units UnitsOf(float3 impulse, float3 arm)
{
    const bool isFinite = IsFinite(impulse);
    const float3 straight = isFinite ? impulse * _ImpulseUnits : float3(0.0, 0.0, 0.0);
    const float3 angular = isFinite ? cross(arm, impulse) * _AngularUnits : float3(0.0, 0.0, 0.0);
    const float3 largest = max(abs(straight), abs(angular));
    if (!isFinite || max(largest.x, max(largest.y, largest.z)) > MOST_UNITS)
    {
        CountEvent(COUNTER_IMPULSE_LIMIT);
    }
    Units units;
    units.Impulse = int3(round(clamp(straight, -MOST_UNITS, MOST_UNITS)));
    units.Angular = int3(round(clamp(angular, -MOST_UNITS, MOST_UNITS)));
    return units;
}

// Adds to a sum of two words. Worked example: -1 is low 0xffffffff, high 0xffffffff; onto 1 it carries, and both words are 0.
void AddWords(uint at, uint low, uint high)
{
    uint was;
    InterlockedAdd(_ImpulseSums[at], low, was);
    const uint carry = was + low < was ? 1u : 0u;
    InterlockedAdd(_ImpulseSums[at + 1u], high + carry);
}

void AddUnits(uint at, int units)
{
    AddWords(at, uint(units), units < 0 ? 0xffffffffu : 0u);
}

float3 ArmOf(uint number, float3 place)
{
    return place - _FloatingStates[number - 1u].Centre;
}

// Gives a body an impulse [N s] at a place.
void GiveImpulse(uint number, float3 impulse, float3 place)
{
    const Units units = UnitsOf(impulse, ArmOf(number, place));
    const uint at = (number - 1u) * IMPULSE_WORDS;
    AddUnits(at, units.Impulse.x);
    AddUnits(at + 2u, units.Impulse.y);
    AddUnits(at + 4u, units.Impulse.z);
    AddUnits(at + 6u, units.Angular.x);
    AddUnits(at + 8u, units.Angular.y);
    AddUnits(at + 10u, units.Angular.z);
}

#endif

#endif
