#ifndef SPHFLUID_FLOATING_BODIES
#define SPHFLUID_FLOATING_BODIES

// Rigid bodies that the liquid moves (FloatingTypes.cs), in simulation space. The frame of a body has its origin at the centre of mass and
// the principal axes.

#define IMPULSE_WORDS 12u // a body: low and high word of x, y, z of the impulse, then of the angular impulse

// Bits of a body's number, as GatherWalls packs one for each plane. Number 0: of no such body; else its state is that before it.
#define BODY_NUMBER_BITS 10u
#define BODY_NUMBER_MASK 1023u

// Mirrored by FloatingState; 96 bytes. Velocities lie between the steps, as those of the particles do.
struct FloatingState
{
    float4 Rotation; // frame of the body to simulation space, a quaternion
    float3 Centre;   // m
    uint Epoch;      // of the input that it was seeded by
    float3 Velocity; // m/s
    float Time;      // s, of the steps in the sums below
    float3 AngularVelocity; // rad/s
    float Layer;     // mass of the particles that touch its largest side, over its own
    float3 Impulse;         // N s: what the liquid gave it since the first step of the frame
    float Unused1;
    float3 AngularImpulse;  // N m s, about the centre of mass
    float Unused2;
};

#endif
