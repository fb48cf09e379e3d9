#ifndef SPHFLUID_STANDARD_MOTION
#define SPHFLUID_STANDARD_MOTION

#include "../../Neighbours/PeriodicAxes.hlsl"

float _TimeStep;
float _KickStep;      // s, from the middle of the last step to the middle of this one; half a step for the first
float _ShellDistance; // m: no particle is let nearer to a wall than this by its own speed

#if defined(FLUID_NO_SLIP)

float _WallViscosity; // beta nu, beta = 1.5: m^2/s
float3 _WallLowX;     // m/s, velocities of the domain's faces, each within its plane
float3 _WallLowY;
float3 _WallLowZ;
float3 _WallHighX;
float3 _WallHighY;
float3 _WallHighZ;

// Morris's sum over a half-space at rest, 14 u^5 (3 - 2u) / R^2, u = 1 - d/R, for three walls at once.
float3 HalfSpaceDrag(float3 d)
{
    const float3 u = max(1.0 - max(d, 0.0) * _InverseSupport, 0.0);
    const float3 u2 = u * u;
    return 14.0 * u2 * u2 * u * (3.0 - 2.0 * u) * (_InverseSupport * _InverseSupport);
}

// The six faces; each rubs along its two axes.
float3 WallFriction(float3 position, float3 velocity)
{
    const float3 rateLow = WhereWalls(HalfSpaceDrag(_DomainHalfSize + position));
    const float3 rateHigh = WhereWalls(HalfSpaceDrag(_DomainHalfSize - position));
    const float3 rates = rateLow + rateHigh;
    const float3 drive = rateLow.x * _WallLowX + rateHigh.x * _WallHighX + rateLow.y * _WallLowY + rateHigh.y * _WallHighY
        + rateLow.z * _WallLowZ + rateHigh.z * _WallHighZ;
    return _WallViscosity * (drive - (rates.yzx + rates.zxy) * velocity);
}

#endif

#if defined(FLUID_MESH_WALLS)

float _FaceDistance; // m: triangles may lie in the domain's faces, so particles do not

// The same for the planes of triangles, against the walls' speeds; twice, for corners.
float3 MeshShell(NearWall wall, float3 velocity)
{
    [unroll]
    for (int turn = 0; turn < 2; turn++)
    {
        [unroll]
        for (int k = 0; k < 3; k++)
        {
            const float least = wall.Approach[k] - max(0.0, wall.Planes[k].w - _ShellDistance) / _TimeStep;
            velocity += max(0.0, least - dot(wall.Planes[k].xyz, velocity)) * wall.Planes[k].xyz;
        }
    }
    return velocity;
}

#if defined(FLUID_NO_SLIP)

float3 MeshFriction(NearWall wall, float3 velocity)
{
    float3 drag = float3(0.0, 0.0, 0.0);
    const uint rubs = (wall.Flags >> 4u) & 3u;
    [unroll]
    for (uint k = 0u; k < 3u; k++)
    {
        if (k == rubs)
        {
            const float3 n = wall.Planes[k].xyz;
            const float3 relative = velocity - wall.Velocity;
            drag = -_WallViscosity * HalfSpaceDrag(wall.Planes[k].www).x * (relative - n * dot(n, relative));
        }
    }
    return drag;
}

#endif

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
    const float3 low = -max(position + _DomainHalfSize - _ShellDistance, 0.0) / _TimeStep;
    const float3 high = max(_DomainHalfSize - position - _ShellDistance, 0.0) / _TimeStep;
    return velocity + WhereWalls(clamp(velocity, low, high) - velocity);
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
    const float3 limit = _DomainHalfSize - WhereWalls(_FaceDistance.xxx);
    const float3 inside = clamp(motion.Position, -limit, limit);
#else
    const float3 inside = clamp(motion.Position, -_DomainHalfSize, _DomainHalfSize);
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
