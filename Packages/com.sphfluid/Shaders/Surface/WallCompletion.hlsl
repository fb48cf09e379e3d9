#ifndef SPHFLUID_WALL_COMPLETION
#define SPHFLUID_WALL_COMPLETION

#include "../Solver/DomainFaces.hlsl"

// No particle stands behind a wall: sums over kernels fall to a half there, in corners to an eighth. Divided by the
// kernel's part inside the domain (exact at one wall, a product of the axes near an edge), they let the surface meet
// the wall level.

// Part of a poly6 kernel that lies on the inner side of a plane at distance s R from its centre, 0 <= s: the integral
// of
// 315/256 (1 - x^2)^4 from -1 to s. A half at the plane, 1 from s = 1 on.
float3 InnerPart(float3 s)
{
    const float3 x = min(s, 1.0);
    const float3 q = x * x;
    return 0.5 + 315.0 / 256.0 * x * (1.0 + q * (-4.0 / 3.0 + q * (6.0 / 5.0 + q * (-4.0 / 7.0 + q / 9.0))));
}

// Parts of a kernel of a radius inside the box along each axis; axes without walls do not count.
float3 AxisPartsInside(float3 position, float3 lower, float3 upper, float radius)
{
    float3 part = InnerPart(max((position - lower) / radius, 0.0)) + InnerPart(max((upper - position) / radius, 0.0)) - 1.0;
#if defined(FLUID_PERIODIC)
    part = _PeriodLength > 0.0 ? float3(1.0, 1.0, 1.0) : part; // no wall: the liquid goes on
#endif
    return part;
}

// Part of a kernel inside, of the parts along the axes.
float KernelPart(float3 parts)
{
    return max(parts.x * parts.y * parts.z, 0.125);
}

// Part of a kernel of a radius inside the box.
float KernelPartInside(float3 position, float3 lower, float3 upper, float radius)
{
    return KernelPart(AxisPartsInside(position, lower, upper, radius));
}

#endif
