#ifndef SPHFLUID_MESH_MOTION
#define SPHFLUID_MESH_MOTION

#include "WallFriction.hlsl"
#include "WallShell.hlsl"

// What triangles do to a velocity.
#if defined(FLUID_MESH_WALLS)

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

#if defined(FLUID_NO_SLIP)

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
    const uint frictional = FrictionalPlane(wall);
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

#endif
