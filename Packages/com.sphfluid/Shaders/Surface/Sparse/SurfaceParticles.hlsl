#ifndef SPHFLUID_SURFACE_PARTICLES
#define SPHFLUID_SURFACE_PARTICLES

// Particles as the surface's field takes them, in the order of the neighbour cells. Lengths in the field's radius R,
// from the grid's minimum.
// xyz: centre of the kernel; w: weight, V W(0). Weight 0: no liquid. Below 0: two kernels of the weight's opposite, apart from the
// centre by the stretch, one to each side.
// Field: sum of w (1 - |x - xyz|^2)^3 over particles nearer than 1. With shapes, |d|^2 stands for d . M d.

// M of a particle's kernel, symmetric.
struct KernelShape
{
    float3 Diagonal; // xx, yy, zz
    float3 Mixed;    // xy, xz, yz
};

// A vector of length 1 at most, 10 bits an axis.
#define NO_STRETCH 0x20080200u

uint PackStretch(float3 part)
{
    const uint3 steps = uint3(round(part * 511.0) + 512.0);
    return steps.x | (steps.y << 10) | (steps.z << 20);
}

float3 UnpackStretch(uint stretch)
{
    const uint3 steps = uint3(stretch, stretch >> 10, stretch >> 20) & 1023u;
    return (float3(steps) - 512.0) / 511.0;
}

float3 _FieldStep;   // cells of the surface grid in R: sample s lies at s _FieldStep
float _FieldRadius;  // R [m]

#endif
