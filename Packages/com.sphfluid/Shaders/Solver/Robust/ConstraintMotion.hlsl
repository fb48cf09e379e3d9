#ifndef SPHFLUID_CONSTRAINT_MOTION
#define SPHFLUID_CONSTRAINT_MOTION

// The motion of a particle by what an iteration changed of the multipliers:
//   dx_i = sum_j (dlambda_i + dlambda_j) (m / (rho0 M)) grad W_ij + dlambda_i grad L_i / M,
// summed up as a displacement of its own from where the substep began: v is that over dt, and equal and opposite changes stay so in float.
// No particle is brought nearer to a wall than the shell, or than it was predicted. A kernel that defines DRAGS adds, in the first motion
// of a substep, dt^2 times what acts on the predicted velocities: laminar viscosity (Morris et al. 1997), the parting of close pairs and
// friction of walls. The iterations behind it have the last word: what parted pairs that no longer approach would add energy. A kernel
// that includes this file has the keywords FLUID_PERIODIC and FLUID_MESH_WALLS, and includes FluidCounters.hlsl before it.
#include "../Cells/Wendland.hlsl"
#include "../Cells/ClosePairs.hlsl"

StructuredBuffer<float4> _Positions; // predicted
StructuredBuffer<float4> _Starts;    // where the substep began
#if defined(DRAGS)
StructuredBuffer<float4> _Velocities; // predicted; w: the id's bits
float _DragStep;        // dt^2, s^2; 0: not the first motion of the substep
float _SlopeFactor;     // m 210 / (pi R^5) / M
float _ViscosityFactor; // 2 nu / rho0
float _LeastSeparation; // m, for particles that share a place
#endif
float _GradientFactor; // m 210 / (pi R^5) / (M rho0)
float _InverseMoment;  // 1 / M

struct PairSums
{
    float Change; // dlambda_i
    float3 Moved;
#if defined(DRAGS)
    uint Id;
    float3 Velocity;
    float3 Push;
    float3 Drag; // without the viscosity
#endif
};

void AddPair(inout PairSums sums, uint other, float w, float3 d, float distanceSquared)
{
    const float slope = WendlandSlope(distanceSquared);
    sums.Moved += (slope * (sums.Change + w)) * d;
#if defined(DRAGS)
    const float3 relativeVelocity = sums.Velocity - _Velocities[other].xyz;
    // Two that share a place part along x, by their order.
    const float side = sums.Id < other ? _LeastSeparation : (sums.Id > other ? -_LeastSeparation : 0.0);
    const float3 apart = distanceSquared < 1e-2 * _LeastSeparation * _LeastSeparation ? d + float3(side, 0.0, 0.0) : d;
    sums.Push += ClosePair(distanceSquared, dot(d, relativeVelocity)) * apart;
    sums.Drag += slope * relativeVelocity;
#endif
}

#if defined(FIRST_MOTION)
#define LONG_TURNS
#endif
#include "../Cells/ListedPairs.hlsl"
#include "../Cells/WallMotion.hlsl"
#include "../Cells/BodyShares.hlsl"

// dx by the pairs, and what the faces of the domain hold.
float3 MovedByPairs(uint id, float4 place)
{
    PairSums sums = (PairSums)0;
    sums.Change = place.w;
#if defined(DRAGS)
    sums.Id = id;
    sums.Velocity = _Velocities[id].xyz;
    sums = ListedPairs(id, place.xyz, sums);
    float3 acceleration = (sums.Push - _ViscosityFactor * sums.Drag) * _SlopeFactor;
    [branch]
    if (IsHeld(place.xyz))
    {
        acceleration += WallFriction(place.xyz, sums.Velocity);
    }
    return _DragStep * acceleration - _GradientFactor * sums.Moved;
#else
    return -_GradientFactor * ListedPairs(id, place.xyz, sums).Moved;
#endif
}

#if defined(FLUID_MESH_WALLS)

// As MeshShell, for places: a plane where the wall is at the end of the substep, and where the particle was predicted.
float3 PlaneShell(NearWall wall, float3 moved, float3 predicted, float3 position, inout float3 changes[WALL_PLANES])
{
    const float3 gone = Separation(predicted, position);
    float3 pushed = float3(0.0, 0.0, 0.0);
    [unroll]
    for (int turn = 0; turn < 2; turn++)
    {
        [unroll]
        for (int k = 0; k < WALL_PLANES; k++)
        {
            const float3 n = wall.Planes[k].xyz;
            const float least = min(_ShellDistance, wall.Planes[k].w + dot(n, gone));
            const float3 change = max(0.0, least - wall.Planes[k].w - dot(n, moved + pushed)) * n;
            pushed += change;
            changes[k] += change;
        }
    }
    return moved + pushed;
}

// dx by the pairs' part and the planes of triangles. changes: what each plane gave the velocity, m/s.
float3 MovedByPlanes(NearWall wall, uint id, float4 place, float3 pushed, out float3 changes[WALL_PLANES])
{
    const float wallChange = place.w * _InverseMoment;
    float3 shares[WALL_PLANES];
    ShareGradient(wall, shares);
    uint k;
    [unroll]
    for (k = 0u; k < uint(WALL_PLANES); k++)
    {
        changes[k] = wallChange * shares[k];
    }
#if defined(DRAGS)
    const float3 held = _DragStep * MeshFriction(wall, _Velocities[id].xyz);
    pushed += held;
    [unroll]
    for (k = 0u; k < uint(WALL_PLANES); k++)
    {
        changes[k] += k == FrictionalPlane(wall) ? held : float3(0.0, 0.0, 0.0);
    }
#endif
    const float3 moved = PlaneShell(wall, pushed + wallChange * DensityOf(wall).Gradient, _Positions[id].xyz, place.xyz, changes);
    [unroll]
    for (k = 0u; k < uint(WALL_PLANES); k++)
    {
        changes[k] /= _TimeStep;
    }
    return moved;
}

#endif

// dx by the pairs' part and the faces of the domain.
float3 MovedByFaces(float4 place, float3 pushed)
{
    return pushed + place.w * _InverseMoment * DomainWalls(place.xyz).Gradient;
}

struct ConstraintMotion
{
    float3 Displacement;
    float3 Position; // at its end
};

// The end of a displacement, in the box.
ConstraintMotion EndOf(uint id, float3 displacement)
{
    const float3 predicted = _Positions[id].xyz;
    const float3 end = _Starts[id].xyz + displacement;
    const float3 image = predicted + Separation(end, predicted); // beside the prediction along periodic axes
    const float3 inside = clamp(image, min(_WallsLow + _ShellDistance, predicted), max(_WallsHigh - _ShellDistance, predicted));
    ConstraintMotion motion;
    motion.Displacement = displacement + (inside == image ? float3(0.0, 0.0, 0.0) : inside - image);
    motion.Position = WrapPosition(inside);
    return motion;
}

#endif
