#ifndef SPHFLUID_SLEEPING
#define SPHFLUID_SLEEPING

// Particles that sleep keep their places and densities, and push the others as they did. MarkSleepers notes one where the sorted
// positions have how far it looks ahead (NeighbourSearch.hlsl): the density, far below zero. As it has no list, its number of neighbours
// says the same to the passes that come later.
#define SLEEPER_SCALE -1099511627776.0 // -2^40, so that no bit of the density is lost
#define SLEEPER 0xffffffffu

#define INSIDE_LIQUID -16.0 // R^2: how far one looks ahead that is not at a surface

// kg/m^3 of one that sleeps, else 0.
float SleepingDensity(float ahead)
{
    return ahead < 1e-9 * SLEEPER_SCALE ? ahead / SLEEPER_SCALE : 0.0;
}

#endif
