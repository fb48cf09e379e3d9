#ifndef SPHFLUID_FLOATING_INPUT
#define SPHFLUID_FLOATING_INPUT

#include "FloatingBodies.hlsl"

// Bits of Flags.
#define FLOATING_SEEDS 1u  // the state begins anew at the pose and the velocities of the input
#define FLOATING_JOINED 2u // it rests on others, or they on it, and all move as one rigid body
#define FLOATING_LEADS 4u  // the first of those

// What the owner of a body says once a frame. Mirrored by FloatingInput; 208 bytes.
struct FloatingInput
{
    float4 Rotation;
    float3 Centre;
    uint Epoch;
    float3 Velocity;
    uint Flags;
    float3 AngularVelocity;
    float InverseMass; // 1/kg
    float3 InverseInertia; // 1/(kg m^2), about the principal axes; 0: does not turn about it
    uint FirstPart;   // of _FloatingParts
    float3 Gravity;   // m/s^2; 0 where it does not act
    uint PartCount;
    float3 FreeX;     // row by row, what a velocity is multiplied by: the identity less the frozen axes
    float Damping;    // 1/s
    float3 FreeY;
    float AngularDamping;
    float3 FreeZ;
    float MostPull;      // m/s^2: what the liquid accelerates it by at most, beyond stopping it
    float3 PushVelocity; // m/s: what others than the liquid changed, over the frame
    float MostSpeed;     // m/s: what the liquid accelerates it to at most
    float3 PushAngularVelocity; // rad/s
    float TurnsPerMetre; // 1/m: of these, for angular velocities
    float3 PushDisplacement; // m
    uint Next;          // number of the next body that moves with it as one; 0: none
    float3 PushRotation; // rad, as a vector
    float Layer; // mass of the particles that touch its largest side, over its own
};

// A collider of a body, where its triangles rest in the body's frame. Mirrored by FloatingPart; 32 bytes.
struct FloatingPart
{
    float4 Rotation; // frame of the triangles to that of the floating body
    float3 Position; // m
    uint Body;       // of _Bodies
};

#endif
