#ifndef SPHFLUID_CONSTRAINT_MOTION
#define SPHFLUID_CONSTRAINT_MOTION

// The motion of a particle by what the last iteration changed of the multipliers:
//   dx_i = sum_j (dlambda_i + dlambda_j) (m / (rho0 M)) grad W_ij + dlambda_i grad L_i / M,
// summed up as a displacement of its own from where the substep began: v is that over dt, and equal and opposite changes stay so in float.
// No particle is brought nearer to a wall than the shell, or than it was predicted. A kernel that includes this file includes
// WallMotion.hlsl before it.

StructuredBuffer<float4> _Positions; // predicted
StructuredBuffer<float4> _Starts;    // where the substep began
float _GradientFactor; // m 210 / (pi R^5) / (M rho0)
float _InverseMoment;  // 1 / M
float _Spacing;        // m
uint _IsFirst;         // 1: of the substep

// How far a velocity has taken the particle from its start. Contact may have ended the prediction elsewhere than the velocity does.
float3 PredictedDisplacement(uint id, float3 velocity)
{
    const float3 gone = Separation(_Positions[id].xyz, _Starts[id].xyz);
    const float3 carried = _TimeStep * velocity;
    const float3 apart = gone - carried;
    return dot(apart, apart) < 1e-6 * _Spacing * _Spacing ? carried : gone;
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
float3 MovedByPlanes(NearWall wall, float4 place, float3 pushed, float3 predicted, out float3 changes[WALL_PLANES])
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
    const float3 moved = PlaneShell(wall, pushed + wallChange * DensityOf(wall).Gradient, predicted, place.xyz, changes);
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
