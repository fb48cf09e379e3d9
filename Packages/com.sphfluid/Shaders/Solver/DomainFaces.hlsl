#ifndef SPHFLUID_DOMAIN_FACES
#define SPHFLUID_DOMAIN_FACES

// A face of the domain is a wall, open, or one with the opposite face. Where each kind is along each axis [m], far away where a face is not
// of the kind: no distance to one needs a further test then. Set by DomainBindings.cs.
float3 _WallsLow;
float3 _WallsHigh;
float3 _OpenLow;
float3 _OpenHigh;

// Periodic axes. A kernel that includes this file declares "#pragma multi_compile_local _ FLUID_PERIODIC" where pairs of particles are its
// work, and elsewhere defines FLUID_PERIODIC: lengths of 0 then leave every number as it is.
#if defined(FLUID_PERIODIC)
float3 _PeriodLength; // m, the box along the axis; 0: the axis has walls
float3 _PeriodRate;   // 1/m, its inverse; 0 likewise
#endif

// A separation, from the nearest image. Lengths and rates of the periods are given: loops then do not read them anew.
float3 NearestImage(float3 d, float3 length, float3 rate)
{
    return d - length * round(d * rate);
}

// From the second position to the first; along periodic axes from the nearest image of the second.
// Worked example on an axis of 1 m: from 0.4 to -0.45 it is 0.15, not -0.85.
float3 Separation(float3 position, float3 from)
{
    float3 d = position - from;
#if defined(FLUID_PERIODIC)
    d = NearestImage(d, _PeriodLength, _PeriodRate);
#endif
    return d;
}

// The position inside the box along periodic axes; the clamp takes a rounding of the faces only.
float3 WrapPosition(float3 position)
{
#if defined(FLUID_PERIODIC)
    const float3 wrapped = position - _PeriodLength * floor(position * _PeriodRate + 0.5);
    const float3 inside = clamp(wrapped, -0.5 * _PeriodLength, 0.5 * _PeriodLength);
    position = _PeriodLength > 0.0 ? inside : position;
#endif
    return position;
}

#endif
