#ifndef SPHFLUID_WALL_MOTION
#define SPHFLUID_WALL_MOTION

// What walls do to velocities and places. A kernel that includes this file includes FluidCounters.hlsl before it.
#include "MeshWalls.hlsl"
#include "WallFriction.hlsl"

float _TimeStep;
float _KickStep;      // s, from the middle of the last step to the middle of this one; half a step for the first

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

#if defined(FLUID_MESH_WALLS)

// What each plane's wall has of the gradient. Of its change each has what lies along its normal, the first the rest.
void ShareGradient(NearWall wall, out float3 shares[WALL_PLANES])
{
    shares = wall.Push;
    float3 rest = wall.Turned;
    [unroll]
    for (int k = 0; k < WALL_PLANES; k++)
    {
        const bool isThere = wall.Planes[k].w < NO_PLANE_DISTANCE * 0.5;
        const float3 own = isThere ? dot(rest, wall.Planes[k].xyz) * wall.Planes[k].xyz : float3(0.0, 0.0, 0.0);
        shares[k] += own;
        rest -= own;
    }
    shares[0] += rest;
}

// As Shell, for the planes of triangles, against the walls' speeds; twice, for corners. changes: what each plane adds to the velocity.
float3 MeshShell(NearWall wall, float3 velocity, inout float3 changes[WALL_PLANES])
{
    [unroll]
    for (int turn = 0; turn < 2; turn++)
    {
        [unroll]
        for (int k = 0; k < WALL_PLANES; k++)
        {
            const float least = wall.Approach[k] - max(0.0, wall.Planes[k].w - _ShellDistance) / _TimeStep;
            const float3 change = max(0.0, least - dot(wall.Planes[k].xyz, velocity)) * wall.Planes[k].xyz;
            velocity += change;
            changes[k] += change;
        }
    }
    return velocity;
}

float _NoSlipViscosity; // m^2/s

// The plane that has the friction; 3 for none.
uint FrictionalPlane(NearWall wall)
{
    return (wall.Flags >> 4u) & 3u;
}

// The rate at which a plane takes the velocity along it, 1/s.
float MeshFrictionRate(NearWall wall, uint k)
{
    const float viscosity = wall.Friction < 0.0 ? _WallViscosity : wall.Friction * _NoSlipViscosity;
    return viscosity * MirrorDrag(wall.Planes[k].www).x;
}

float3 MeshFriction(NearWall wall, float3 velocity)
{
    float3 drag = float3(0.0, 0.0, 0.0);
    const uint frictional = _NoSlipViscosity > 0.0 ? FrictionalPlane(wall) : 3u;
    [unroll]
    for (uint k = 0u; k < uint(WALL_PLANES); k++)
    {
        if (k == frictional)
        {
            const float3 n = wall.Planes[k].xyz;
            const float3 relative = velocity - wall.Velocity;
            drag = -MeshFrictionRate(wall, k) * (relative - n * dot(n, relative));
        }
    }
    return drag;
}

#endif

#endif
