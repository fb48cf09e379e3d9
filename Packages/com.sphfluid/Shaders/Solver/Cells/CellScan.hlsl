#ifndef SPHFLUID_CELL_SCAN
#define SPHFLUID_CELL_SCAN

#include "CellSums.hlsl"

groupshared uint sums[SCAN_THREADS];

// Sum of all threads' values; every thread gets it.
uint GroupSum(uint thread, uint value)
{
    sums[thread] = value;
    GroupMemoryBarrierWithGroupSync();
    for (uint width = SCAN_THREADS / 2u; width > 0u; width >>= 1)
    {
        if (thread < width)
        {
            sums[thread] += sums[thread + width];
        }
        GroupMemoryBarrierWithGroupSync();
    }
    const uint sum = sums[0];
    GroupMemoryBarrierWithGroupSync();
    return sum;
}

// Sum of the values of the threads before this one.
uint GroupSumBefore(uint thread, uint value)
{
    sums[thread] = value;
    GroupMemoryBarrierWithGroupSync();
    for (uint reach = 1u; reach < SCAN_THREADS; reach <<= 1)
    {
        const uint add = thread >= reach ? sums[thread - min(reach, thread)] : 0u;
        GroupMemoryBarrierWithGroupSync();
        sums[thread] += add;
        GroupMemoryBarrierWithGroupSync();
    }
    return sums[thread] - value;
}

// Sum of what the groups before this one hold, from the parts that whoever counted left.
uint SumOfGroupsBefore(uint begin, uint group, uint thread)
{
    uint before = 0u;
    for (uint part = thread; part < group * SCAN_SUM_PARTS; part += SCAN_THREADS)
    {
        before += _CellTableOut[begin + part];
    }
    return GroupSum(thread, before);
}

#endif
