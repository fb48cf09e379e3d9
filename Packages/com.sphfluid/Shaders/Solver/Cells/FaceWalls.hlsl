#ifndef SPHFLUID_FACE_WALLS
#define SPHFLUID_FACE_WALLS

#include "Wendland.hlsl"
#include "../DomainFaces.hlsl"

// A wall adds the density of the particle's own mirror layers, and pushes by the gradient of just that, so that walls hold
// energy as the liquid does: the usual forms do not, and a pool boils on them. Profile of a plane at distance d:
//   w(z)  = 21 (1/14 - z^2/2 + 5 z^4/2 - 4 z^5 + 5 z^6/2 - 4 z^7/7), the slice integral of Wendland's C2 at z = distance/R
//   L(d)  = (1/kappa) sum_{l=0..2} w(z_l),  z_l = (2d + l dx)/R < 1
// Worked example: kappa = 2, d = dx/2: z_0 = 0.5, L = 0.129, the deficit of the lattice there.
float _SupportRatio;     // kappa = R/dx
float _MirrorSpacing;    // dx/R

struct WallDensity
{
    float Value;     // over rho0
    float3 Gradient; // 1/m
};

// x: L(d), y: -L'(d) R.
float2 MirrorProfile(float d)
{
    float2 sum = float2(0.0, 0.0);
    for (int l = 0; l < 3; l++)
    {
        const float z = min(2.0 * max(d, 0.0) * _InverseSupport + float(l) * _MirrorSpacing, 1.0);
        const float z2 = z * z;
        const float u = (1.0 - z) * (1.0 - z);
        sum.x += 1.0 / 14.0 - z2 * (0.5 - z2 * (2.5 - 4.0 * z + 2.5 * z2 - (4.0 / 7.0) * z2 * z));
        sum.y += z * u * u * (4.0 * z + 1.0);
    }
    return sum * float2(21.0, 42.0) / _SupportRatio;
}

// The six faces of the domain: 1 - L = product over the faces, which is exact for the corners of a lattice. Nothing in a kernel that
// defines FLUID_MIRRORS and sums the liquid's images itself.
WallDensity DomainWalls(float3 position)
{
    WallDensity walls;
    walls.Value = 0.0;
    walls.Gradient = float3(0.0, 0.0, 0.0);
#if !defined(FLUID_MIRRORS)
    const float reach = 0.5 / _InverseSupport;
    if (any(min(position - _WallsLow, _WallsHigh - position) < reach))
    {
        float3 open = float3(1.0, 1.0, 1.0);
        float3 slope = float3(0.0, 0.0, 0.0);
        [unroll]
        for (int axis = 0; axis < 3; axis++)
        {
            const float2 low = MirrorProfile(position[axis] - _WallsLow[axis]);
            const float2 high = MirrorProfile(_WallsHigh[axis] - position[axis]);
            open[axis] = (1.0 - low.x) * (1.0 - high.x);
            slope[axis] = high.y * (1.0 - low.x) - low.y * (1.0 - high.x);
        }
        walls.Value = 1.0 - open.x * open.y * open.z;
        walls.Gradient = slope * _InverseSupport * float3(open.y * open.z, open.x * open.z, open.x * open.y);
    }
#endif
    return walls;
}

#endif
