#ifndef SPHFLUID_WALL_STEP
#define SPHFLUID_WALL_STEP

// The end of a step: what walls do to a velocity and what they get for it, leapfrog, and the count of the cell that the particle ends in.
#include "../Cells/CellCounting.hlsl"
#include "../Cells/NeighbourList.hlsl"
#include "../Cells/WallMotion.hlsl"
#include "../Cells/BodyShares.hlsl"
#include "../WallForces/WallPatches.hlsl"

RWStructuredBuffer<float4> _NewVelocitiesOut;
float _WallPush; // rho0 / M
float _WallStiffness; // (c dt / M)^2, m^2

struct WallStep
{
    float3 Kicked;  // the velocity, m/s
    float FacePush; // on the faces of the domain: what their -L' is multiplied by, m^2/s
    float3 FaceKick; // what images in the faces did to the velocity along their normals, m/s
#if defined(FLUID_FLOATING_BODIES)
    BodyShares Given;
#endif
};

#if defined(FLUID_WALL_FORCES)

// To the faces of the domain. push: what the pressure does, -L' is multiplied by it, m^2/s; cut: what the shell and the face took, m/s.
void GiveFaces(float3 position, float push, float3 cut)
{
    const float3 below = position - _WallsLow;
    const float3 above = _WallsHigh - position;
    float3 open = float3(1.0, 1.0, 1.0);
    float3 low = float3(0.0, 0.0, 0.0);
    float3 high = float3(0.0, 0.0, 0.0);
    const bool near = any(min(below, above) < 0.5 / _InverseSupport);
    [unroll]
    for (int axis = 0; axis < 3; axis++)
    {
        const float2 lowProfile = MirrorProfile(below[axis]);
        const float2 highProfile = MirrorProfile(above[axis]);
        open[axis] = (1.0 - lowProfile.x) * (1.0 - highProfile.x);
        low[axis] = lowProfile.y * (1.0 - highProfile.x);
        high[axis] = highProfile.y * (1.0 - lowProfile.x);
    }
    const float3 both = near ? push * _InverseSupport * float3(open.y * open.z, open.x * open.z, open.x * open.y) : float3(0.0, 0.0, 0.0);
    low = low * both + max(cut, 0.0);
    high = high * both + max(-cut, 0.0);
    [loop]
    for (uint face = 0u; face < 6u; face++)
    {
        const uint along = face >> 1u;
        const float3 direction = float3(along == 0u ? 1.0 : 0.0, along == 1u ? 1.0 : 0.0, along == 2u ? 1.0 : 0.0);
        const bool isHigh = (face & 1u) != 0u;
        const float change = dot(direction, isHigh ? high : low);
        [branch]
        if (change != 0.0)
        {
            const float3 normal = isHigh ? -direction : direction;
            GiveToPatches(position - normal * dot(direction, isHigh ? above : below), normal, normal * change);
        }
    }
}

#if defined(FLUID_MESH_WALLS)

// Of the planes that a particle near triangles sees, those of the domain among them.
void GivePlanes(NearWall wall, float3 position, float3 changes[WALL_PLANES])
{
    [loop] // one copy of the loop over rectangles in the kernel, not three
    for (uint k = 0u; k < uint(WALL_PLANES); k++)
    {
        const float3 change = k == 0u ? changes[0] : k == 1u ? changes[1] : changes[2];
        [branch]
        if (any(change != 0.0))
        {
            const float4 plane = k == 0u ? wall.Planes[0] : k == 1u ? wall.Planes[1] : wall.Planes[2];
            GiveToPatches(position - plane.w * plane.xyz, plane.xyz, change);
        }
    }
}

#endif

#endif

#if defined(FLUID_MESH_WALLS)

#if defined(FLUID_FLOATING_BODIES)

// What a particle gets in a step from a body that it moves. As from a wall that does not give way, a layer of particles and a body that
// is lighter would throw each other off, with more energy than they had: the stiffness acts on the mass of both, and a step can bring
// the body far into the pressure before it is felt. So the push is that of the step's end, by Euler's implicit rule, and nearer than half
// a spacing the body and its layer close in no further, as in an inelastic impact.
// share: of the gradient; kicked: the velocity with the push; layer: mass of the layer over that of the body.
float3 ChangeByBody(float3 push, float3 share, float3 kicked, float4 plane, float approach, float layer)
{
    const float3 free = kicked - push;
    const float size = length(push);
    const float stiffness = _WallStiffness * dot(share, share);
    const float late = max(0.0, size + stiffness * (approach - dot(plane.xyz, free))) / (1.0 + stiffness * (1.0 + layer));
    const float3 yielding = size > 0.0 ? push * (late / size) : push;
    const float least = approach - max(0.0, plane.w - 2.0 * _ShellDistance) / _TimeStep;
    return yielding + max(0.0, least - dot(plane.xyz, free + yielding)) / (1.0 + layer) * plane.xyz;
}

void YieldToBodies(uint id, NearWall wall, float push, float3 shares[WALL_PLANES], inout float3 changes[WALL_PLANES],
    inout float3 kicked)
{
    const uint numbers = LISTS[_WallBodiesBegin + id];
    [unroll]
    for (uint k = 0u; k < uint(WALL_PLANES); k++)
    {
        const uint number = (numbers >> (BODY_NUMBER_BITS * k)) & BODY_NUMBER_MASK;
        const float layer = number != 0u ? _FloatingStates[max(number, 1u) - 1u].Layer : 0.0;
        [branch]
        if (layer > 0.0) // 0: one that nothing moves
        {
            const float3 before = -_KickStep * push * shares[k];
            const float3 more = ChangeByBody(before, shares[k], kicked, wall.Planes[k], wall.Approach[k], layer) - before;
            changes[k] += more;
            kicked += more;
        }
    }
}

#endif

// The planes of triangles. push: rho0 P / M; friction: what they take of the velocity, m/s^2; both have been added already.
void StepAtPlanes(uint id, NearWall wall, float3 position, float push, float3 friction, inout WallStep step)
{
    float3 shares[WALL_PLANES];
    ShareGradient(wall, shares);
    float3 changes[WALL_PLANES];
    [unroll]
    for (uint k = 0u; k < uint(WALL_PLANES); k++)
    {
        changes[k] = _KickStep * ((k == FrictionalPlane(wall) ? friction : float3(0.0, 0.0, 0.0)) - push * shares[k]);
    }
#if defined(FLUID_FLOATING_BODIES)
    YieldToBodies(id, wall, push, shares, changes, step.Kicked);
#endif
    step.Kicked = MeshShell(wall, step.Kicked, changes);
#if defined(FLUID_WALL_FORCES)
    GivePlanes(wall, position, changes);
    step.FacePush = 0.0; // planes stand for the faces
#endif
#if defined(FLUID_FLOATING_BODIES)
    step.Given = SharesOf(id, changes, position);
#endif
}

#endif

// Taken along to the next density.
float StepDensity(uint id)
{
    return asfloat(_Neighbours[_DensitiesBegin + id]);
}

// number: the bits of the particle's id, as the w of its velocity.
void EndStep(uint id, float number, float3 position, WallStep step)
{
    const Motion motion = Leapfrog(position, step.Kicked);
#if defined(FLUID_WALL_FORCES)
    const float3 cut = motion.Velocity - step.Kicked;
    GiveFaces(position, step.FacePush, step.FaceKick + (IsFinite(cut) ? cut : float3(0.0, 0.0, 0.0)));
#endif
    _NewVelocitiesOut[id] = float4(motion.Velocity, number);
#if defined(FLUID_MESH_WALLS)
    _NewPositionsOut[id] = float4(motion.Position, StepDensity(id)); // contact may still change it, and counts it
#else
    CountInCell(id, float4(motion.Position, StepDensity(id)));
#endif
    CountMaximum(COUNTER_MAX_SPEED, length(motion.Velocity));
}

// Of a particle that sleeps, which RestSleepers has left where it is.
void CountSleeper(uint id, float3 position)
{
#if !defined(FLUID_MESH_WALLS)
    CountInCell(id, float4(position, StepDensity(id)));
#endif
}

#endif
