#ifndef SPHFLUID_KERNEL_SHAPES
#define SPHFLUID_KERNEL_SHAPES

// Kernels stretched along the surface (Yu and Turk 2010): M = sum over axes of q q^T / a^2, with the axes q and the
// lengths a of the covariance of a particle's neighbourhood, scaled to the volume of a ball.
#include "SurfaceParticles.hlsl"

// Longest over shortest axis, and how many neighbours a direction needs; particles with no more get a small ball.
#define SHAPE_RATIO 4.0
#define SHAPE_NEIGHBOURS 6.0
#define SHAPE_LONE 0.5

// A rotation of Jacobi's method in the plane of p and q; r is the third axis.
void Rotate(inout float pp, inout float qq, inout float pq, inout float rp, inout float rq, inout float3 p, inout float3 q)
{
    if (abs(pq) > 1e-12)
    {
        const float theta = (qq - pp) / (2.0 * pq);
        const float t = (theta >= 0.0 ? 1.0 : -1.0) / (abs(theta) + sqrt(theta * theta + 1.0));
        const float c = rsqrt(t * t + 1.0);
        const float s = t * c;
        pp -= t * pq;
        qq += t * pq;
        pq = 0.0;
        const float2 third = float2(c * rp - s * rq, s * rp + c * rq);
        rp = third.x;
        rq = third.y;
        const float3 turned = c * p - s * q;
        q = s * p + c * q;
        p = turned;
    }
}

void AddAxis(inout KernelShape shape, float3 axis, float axisLength)
{
    const float rate = 1.0 / (axisLength * axisLength);
    shape.Diagonal += rate * axis * axis;
    shape.Mixed += rate * axis.xxy * axis.yzz;
}

// Whether the particles around one are spread out at all, and so have axes: coincident ones have none. Variances in
// R^2.
bool HasAxes(float3 variances)
{
    return dot(variances, 1.0) > 1e-6;
}

// Shape of a kernel from the covariance; its volume stays, so its weight does too.
KernelShape ShapeOf(float3 diagonal, float3 mixed)
{
    float3 x = float3(1.0, 0.0, 0.0);
    float3 y = float3(0.0, 1.0, 0.0);
    float3 z = float3(0.0, 0.0, 1.0);
    for (int sweep = 0; sweep < 5; sweep++)
    {
        Rotate(diagonal.x, diagonal.y, mixed.x, mixed.y, mixed.z, x, y);
        Rotate(diagonal.x, diagonal.z, mixed.y, mixed.x, mixed.z, x, z);
        Rotate(diagonal.y, diagonal.z, mixed.z, mixed.x, mixed.y, y, z);
    }

    const float longest = max(diagonal.x, max(diagonal.y, diagonal.z));
    const float3 axes = max(diagonal, longest / SHAPE_RATIO);
    const float3 lengths = axes * exp2(log2(axes.x * axes.y * axes.z) * (-1.0 / 3.0));
    KernelShape shape;
    shape.Diagonal = 0.0;
    shape.Mixed = 0.0;
    AddAxis(shape, x, lengths.x);
    AddAxis(shape, y, lengths.y);
    AddAxis(shape, z, lengths.z);
    return shape;
}

KernelShape LoneShape()
{
    KernelShape shape;
    shape.Diagonal = 1.0 / (SHAPE_LONE * SHAPE_LONE);
    shape.Mixed = 0.0;
    return shape;
}

#endif
