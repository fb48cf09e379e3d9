#ifndef SPHFLUID_CORRECTED_PRESSURE
#define SPHFLUID_CORRECTED_PRESSURE

// What the correction adds to the pairs of a step, m sum_j (P_i (B_i - 1) + P_j (B_j - 1)) grad W, and the offset o of the density: it
// fills what a surface cuts off the sum, evens out its noise by diffusion (after Antuono et al. 2012), takes what the corrected pressure
// works, q, and fades inside:
//   do_i/dt = 0.1 R c sum_j (m/rho0) (-W'/r) (rho_j - rho_i - (rho0/c^2) g.(x_j - x_i)) + q q^2/(q^2 + t^2) + ...
//   q = (m/M) sum_j ((B_i - 1) grad W).(v_i - v_j),  t = 0.0015 rho0 c/R: calm liquid is left alone.
// And the push of the images in the faces, whole. Made for the pass that goes through the pairs anyway.
#include "FaceImages.hlsl"
#include "SymmetricMatrix.hlsl"
#include "OffsetBits.hlsl"

RWStructuredBuffer<uint4> _CorrectionsOut; // B - 1 as half floats until the next sort, and the bits of o, kg/m^3; 0: not known yet
float _RestDensity;
float3 _HydrostaticSlope;  // rho0 g / c^2, kg/m^4
float _OffsetFactor;       // 0.1 R c dt m 210 / (pi R^5 rho0)
float _OffsetStep;         // dt, s
float _WorkThreshold;      // t, kg/(m^3 s)
float _OffsetFading;       // what of an offset fades in a step, more of one far below 0; one above what a surface cuts off is cut at once
float _FaceStiffness;      // (c dt/M)^2 of the square of such a sum
float _SlopeToGradient;    // m 210 / (pi R^4 rho0): sums of slopes to R grad C

struct CorrectedSums
{
    FaceImages Images;
    SymmetricMatrix Own; // B - 1 of the particle itself
    float Density;       // its density, no less than rho0
    float3 Push;         // without the factor, as the rest
    float3 FromFaces;    // what of it is square to the faces of images
    float3 Slope;
    float Rate;          // of the offset, by diffusion
    float Work;          // sum of the slopes times (B_i - 1) d . v
};

float DensityNoLessThanRest(uint id)
{
    return max(asfloat(_Neighbours[_DensitiesBegin + id]), _RestDensity);
}

CorrectedSums OwnCorrection(uint id, float3 position)
{
    CorrectedSums sums = (CorrectedSums)0;
    sums.Images = ImagesAt(position);
    sums.Own = UnpackMatrix(_CorrectionsOut[id].xyz);
    sums.Density = DensityNoLessThanRest(id);
    return sums;
}

// Of the images of a neighbour, or of the particle's own.
void AddImages(inout CorrectedSums sums, uint other, float pressure, float otherPressure, float3 d, float3 velocity, float3 otherVelocity)
{
    const SymmetricMatrix correction = UnpackMatrix(_CorrectionsOut[other].xyz);
    FOR_EACH_IMAGE(sums.Images, set)
    {
        const FaceImage image = ImageOf(sums.Images, set, d, dot(d, d));
        const float3 slope = WendlandSlope(image.DistanceSquared) * image.Separation;
        const float3 own = Times(sums.Own, slope);
        const float3 push = pressure * (slope + own) + otherPressure * (slope + Times(Mirrored(correction, image.Mirror), slope));
        sums.Push += push;
        sums.FromFaces += image.Mirror < 0.0 ? push : float3(0.0, 0.0, 0.0);
        sums.Slope += slope;
        sums.Work += dot(own, velocity - image.Mirror * otherVelocity);
    }
}

// pressure: P of the particle itself; otherPressure: of the neighbour.
void AddCorrected(inout CorrectedSums sums, uint other, float pressure, float otherPressure, float slope, float3 d, float3 relativeVelocity)
{
    const SymmetricMatrix correction = UnpackMatrix(_CorrectionsOut[other].xyz);
    const float3 own = Times(sums.Own, d);
    const float density = DensityNoLessThanRest(other);
    const bool isPressed = min(density, sums.Density) > _RestDensity; // else it may fall
    sums.Push += slope * (pressure * own + otherPressure * Times(correction, d));
    sums.Slope += slope * d;
    sums.Rate += slope * (density - sums.Density + (isPressed ? dot(_HydrostaticSlope, d) : 0.0));
    sums.Work += slope * dot(own, relativeVelocity);
}

// What flies into an edge compresses its own images faster than a step can follow, and would be thrown back with more energy than it had.
// So the push of the faces is that of the step's end, by Euler's implicit rule. Liquid at rest, whose slopes square to the faces add up to
// next to nothing, is left alone: a pool would be stirred along its edges. wallGradient: of what triangles add to the density, 1/m.
void YieldFaces(inout CorrectedSums sums, float3 wallGradient)
{
    const float3 all = sums.Slope - wallGradient / (_InverseSupport * _SlopeToGradient);
    const float3 slope = MaskOf(sums.Images.Faces | sums.Images.Faces >> 3u) ? all : 0.0;
    const float late = 1.0 / (1.0 + max(_FaceStiffness * dot(slope, slope) - 0.03, 0.0));
    sums.Push -= (1.0 - late) * sums.FromFaces;
    sums.FromFaces *= late;
}

// What the summed density lacks at a flat surface, over rho0, by R |grad C|: within 5 % of a lattice's, kappa = 2.25, whose topmost layer
// has 1.44.
float Deficit(float gradient)
{
    const float flat = min(gradient, 1.44);
    return flat * (0.0488 + 0.0966 * flat);
}

// After all neighbours.
void MoveOffset(uint id, CorrectedSums sums, float3 wallGradient)
{
    const float density = asfloat(_Neighbours[_DensitiesBegin + id]);
    const float offset = asfloat(_CorrectionsOut[id].w);
    const float gradient = length(wallGradient / _InverseSupport - _SlopeToGradient * sums.Slope);
    const float most = gradient > 0.15 ? 1.5 * _RestDensity * Deficit(gradient) : 0.0;
    const float filled = clamp(offset + max(0.999996 * _RestDensity - density, 0.0), 0.0, most); // as the mass: rounding is no pressure
    const float target = gradient > 0.3 ? filled : 0.0;
    // What the work takes below 0 would let particles crowd: it comes back the faster the more it is.
    const float below = min(offset, 0.0) / (0.03 * _RestDensity);
    const float slow = min(_OffsetFading * (1.0 + 20.0 * below * below), 0.1);
    const float fading = offset > max(most, 0.01 * _RestDensity) ? 1.0 : slow;
    const float work = -_SlopeFactor * sums.Work;
    const float kept = work * work / (work * work + _WorkThreshold * _WorkThreshold);
    const float change = _OffsetFactor * sums.Rate + _OffsetStep * kept * work;
    const bool starts = offset == 0.0;
    const float next = starts ? max(filled, 1e-6 * _RestDensity) : offset + fading * (target - offset) + change;
    const uint bits = asuint(abs(next) < _RestDensity ? next : 0.0); // what is not a number is not known
    _CorrectionsOut[id].w = (bits & ~(OFFSET_STARTS | OFFSET_HIT)) | (starts && bits != 0u ? OFFSET_STARTS : 0u);
}

#endif
