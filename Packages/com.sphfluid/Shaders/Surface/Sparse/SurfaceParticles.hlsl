#ifndef SPHFLUID_SURFACE_PARTICLES
#define SPHFLUID_SURFACE_PARTICLES

// Particles as the surface's field takes them, in the order of the neighbour cells. Lengths in the field's radius R,
// from the grid's minimum.
// xyz: centre of the kernel; w: weight, V W(0). Weight 0: no liquid.
// Field: sum of w (1 - |x - xyz|^2)^3 over particles nearer than 1. With shapes, |d|^2 stands for d . M d.

// M of a particle's kernel, symmetric.
struct KernelShape
{
    float3 Diagonal; // xx, yy, zz
    float3 Mixed;    // xy, xz, yz
};

float3 _FieldStep;   // cells of the surface grid in R: sample s lies at s _FieldStep
float _FieldRadius;  // R [m]

#endif
