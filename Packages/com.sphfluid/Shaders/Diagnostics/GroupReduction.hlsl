#ifndef SPHFLUID_GROUP_REDUCTION
#define SPHFLUID_GROUP_REDUCTION

// Sums and maxima over the threads of a group, in an order that does not depend on thread timing.
// All threads of the group call them, and all receive the result. Needs FluidTypes.hlsl.
groupshared float4 groupLanes[NUMBER_THREADS];

// Worked example with four threads: (a + c) + (b + d).
float4 GroupSum(float4 value, uint lane)
{
    groupLanes[lane] = value;
    GroupMemoryBarrierWithGroupSync();
    for (uint reach = NUMBER_THREADS / 2; reach > 0u; reach >>= 1)
    {
        if (lane < reach)
        {
            groupLanes[lane] += groupLanes[lane + reach];
        }
        GroupMemoryBarrierWithGroupSync();
    }
    const float4 sum = groupLanes[0];
    GroupMemoryBarrierWithGroupSync();
    return sum;
}

float4 GroupMaximum(float4 value, uint lane)
{
    groupLanes[lane] = value;
    GroupMemoryBarrierWithGroupSync();
    for (uint reach = NUMBER_THREADS / 2; reach > 0u; reach >>= 1)
    {
        if (lane < reach)
        {
            groupLanes[lane] = max(groupLanes[lane], groupLanes[lane + reach]);
        }
        GroupMemoryBarrierWithGroupSync();
    }
    const float4 maximum = groupLanes[0];
    GroupMemoryBarrierWithGroupSync();
    return maximum;
}

#endif
