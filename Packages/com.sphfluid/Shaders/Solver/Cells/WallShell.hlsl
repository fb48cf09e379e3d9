#ifndef SPHFLUID_WALL_SHELL
#define SPHFLUID_WALL_SHELL

#include "../PeriodicAxes.hlsl"

float _TimeStep;
float _KickStep;      // s, from the middle of the last step to the middle of this one; half a step for the first
float _ShellDistance; // m: no particle is let nearer to a wall than this by its own speed

#if defined(FLUID_MESH_WALLS)

float _FaceDistance; // m: triangles may lie in the domain's faces, so particles do not

#endif

struct Motion
{
    float3 Position;
    float3 Velocity;
};

// A velocity towards a face that would bring the particle nearer than the shell in this step is cut to what just reaches it.
// Velocities only: pushing positions in dense liquid would add energy.
float3 Shell(float3 position, float3 velocity)
{
    const float3 low = -max(position - _WallsLow - _ShellDistance, 0.0) / _TimeStep;
    const float3 high = max(_WallsHigh - position - _ShellDistance, 0.0) / _TimeStep;
    return clamp(velocity, low, high);
}

// Leapfrog with the velocity half a step after the position's last force; a step of another length kicks by the mean.
Motion Leapfrog(float3 position, float3 kicked)
{
    Motion motion;
    motion.Velocity = Shell(position, kicked);
    motion.Position = position + _TimeStep * motion.Velocity;
    if (!IsFinite(motion.Position) || !IsFinite(kicked)) // before the shell: a clamp may hide it
    {
        CountEvent(COUNTER_NON_FINITE); // it stays where it was, at rest
        motion.Position = position;
        motion.Velocity = float3(0.0, 0.0, 0.0);
    }
    motion.Position = WrapPosition(motion.Position);
#if defined(FLUID_MESH_WALLS)
    const float3 inside = clamp(motion.Position, _WallsLow + _FaceDistance, _WallsHigh - _FaceDistance);
#else
    const float3 inside = clamp(motion.Position, _WallsLow, _WallsHigh);
#endif
    if (any(inside != motion.Position))
    {
        CountEvent(COUNTER_DOMAIN_CLAMP);
        motion.Velocity *= float3(inside == motion.Position);
        motion.Position = inside;
    }
    return motion;
}

#endif
