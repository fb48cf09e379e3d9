#ifndef SPHFLUID_CORRECTED_PRESSURE
#define SPHFLUID_CORRECTED_PRESSURE

// What the correction adds to the pairs of a step, m sum_j (P_i (B_i - 1) + P_j (B_j - 1)) grad W, and the offset o of the density, which
// fills what a surface cuts off the sum, evens out its noise by diffusion (after Antuono et al. 2012) and fades inside:
//   do_i/dt = 0.1 R c sum_j (m/rho0) (-W'/r) (rho_j - rho_i - (rho0/c^2) g.(x_j - x_i)) + ...
// Made for the pass that goes through the pairs anyway.
#include "SymmetricMatrix.hlsl"
#include "OffsetStart.hlsl"

RWStructuredBuffer<uint4> _CorrectionsOut; // B - 1 as half floats until the next sort, and the bits of o, kg/m^3; 0: not known yet
float _RestDensity;
float _Diffusivity;        // 0.1 R c, m^2/s
float3 _HydrostaticSlope;  // rho0 g / c^2, kg/m^4
float _OffsetFactor;       // dt m 210 / (pi R^5 rho0), s/m^2
float2 _OffsetFading;      // what of an offset fades in a step, and of one above what a surface cuts off
float _SlopeToGradient;    // m 210 / (pi R^4 rho0): sums of slopes to R grad C

struct CorrectedSums
{
    SymmetricMatrix Own; // B - 1 of the particle itself
    float Density;       // its density, no less than rho0
    float3 Push;         // without the factor, as the rest
    float3 Slope;
    float Rate;          // of the offset
};

float DensityNoLessThanRest(uint id)
{
    return max(asfloat(_Neighbours[_DensitiesBegin + id]), _RestDensity);
}

CorrectedSums OwnCorrection(uint id)
{
    CorrectedSums sums = (CorrectedSums)0;
    sums.Own = UnpackMatrix(_CorrectionsOut[id].xyz);
    sums.Density = DensityNoLessThanRest(id);
    return sums;
}

// pressure: P of the particle itself; otherPressure: of the neighbour.
void AddCorrected(inout CorrectedSums sums, uint other, float pressure, float otherPressure, float slope, float3 d, float3 relativeVelocity)
{
    const SymmetricMatrix correction = UnpackMatrix(_CorrectionsOut[other].xyz);
    SymmetricMatrix both;
    both.Diagonal = pressure * sums.Own.Diagonal + otherPressure * correction.Diagonal;
    both.Shear = pressure * sums.Own.Shear + otherPressure * correction.Shear;
    sums.Push += slope * Times(both, d);
    sums.Slope += slope * d;
    sums.Rate += slope * _Diffusivity * (DensityNoLessThanRest(other) - sums.Density);
}

// What the summed density lacks at a flat surface, over rho0, by R |grad C|: within 5 % of a lattice's, kappa = 2.25, whose topmost layer
// has 1.44.
float Deficit(float gradient)
{
    const float flat = min(gradient, 1.44);
    return flat * (0.0488 + 0.0966 * flat);
}

// wallGradient: of what walls add to the density, 1/m. After all neighbours.
void MoveOffset(uint id, CorrectedSums sums, float3 wallGradient)
{
    const float density = asfloat(_Neighbours[_DensitiesBegin + id]);
    const float offset = asfloat(_CorrectionsOut[id].w);
    const float gradient = length(wallGradient / _InverseSupport - _SlopeToGradient * sums.Slope);
    const float most = gradient > 0.15 ? 1.5 * _RestDensity * Deficit(gradient) : 0.0;
    const float filled = clamp(offset + max(_RestDensity - density, 0.0), 0.0, most);
    const float target = gradient > 0.3 ? filled : 0.0;
    const float fading = offset > max(most, 0.01 * _RestDensity) ? _OffsetFading.y : _OffsetFading.x;
    const float diffused = _OffsetFactor * (sums.Rate + _Diffusivity * dot(_HydrostaticSlope, sums.Slope));
    const bool starts = offset == 0.0;
    const float next = starts ? filled : offset + fading * (target - offset) + diffused;
    const uint bits = asuint(abs(next) < _RestDensity ? next : 0.0); // what is not a number is not known
    _CorrectionsOut[id].w = starts && bits != 0u ? bits | OFFSET_STARTS : bits & ~OFFSET_STARTS;
}

#endif
