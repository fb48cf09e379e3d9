#ifndef SPHFLUID_SLEEPING
#define SPHFLUID_SLEEPING

// Particles that sleep keep their places and densities, and push the others as they did. MarkSleepers notes one where the sorted
// positions have how far it looks ahead (NeighbourSearch.hlsl): the density, far below zero. As it has no list, its number of neighbours
// says the same to the passes that come later.
#define SLEEPER_SCALE -1099511627776.0 // -2^40, so that no bit of the density is lost
#define SLEEPER 0xffffffffu

// In the table of the cells behind the ranks: ALL_GROUPS; then how many groups of CELL_THREADS sorted particles have one awake, and which;
// behind as many places as there may be groups, the same of those where all sleep. What takes all groups is given a list that begins with
// ALL_GROUPS.
#define ALL_GROUPS 0xffffffffu
#define NO_GROUP 0x3ffffffu // CELL_THREADS of it is no particle

#define INSIDE_LIQUID -16.0 // R^2: how far one looks ahead that is not at a surface

// kg/m^3 of one that sleeps, else 0.
float SleepingDensity(float ahead)
{
    return ahead < 1e-9 * SLEEPER_SCALE ? ahead / SLEEPER_SCALE : 0.0;
}

uint _GroupListBegin;

// Particle of a thread of a dispatch over the groups of a list; of the awake it may also be one that sleeps beside them.
uint ListedParticle(uint3 groupId, uint groupIndex)
{
    uint group = groupId.y * CELL_MAX_GROUPS + groupId.x;
    const uint listed = CELL_TABLE[_GroupListBegin];
    [branch]
    if (listed != ALL_GROUPS)
    {
        group = group < listed ? CELL_TABLE[_GroupListBegin + 1u + min(group, max(listed, 1u) - 1u)] : NO_GROUP;
    }
    return group * CELL_THREADS + groupIndex;
}

#endif
