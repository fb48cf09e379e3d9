#ifndef SPHFLUID_COLLISION_FORCE
#define SPHFLUID_COLLISION_FORCE

// The thesis's CollisionForce (6.3.3): point against triangle, "affected by the distance between the given particle
// and the object". A damped spring per unit mass that only pushes.
#include "Packages/com.sphfluid/Shaders/Collision/CollisionTypes.hlsl"
#include "Packages/com.sphfluid/Shaders/Collision/TriangleQueries.hlsl"
#include "Packages/com.sphfluid/Shaders/Solver/WallDrag.hlsl"

StructuredBuffer<CollisionTriangle> _Triangles;
StructuredBuffer<CollisionCollider> _Colliders;
uint _ColliderCount;
float3 _DomainHalfSize;
float _TimeStep;
float _KickStep;      // s, what the acceleration is multiplied by: the mean of this step and the last
float _WallStiffness; // 1/s^2
float _WallDamping;   // 1/s
float _WallDistance;  // m: contact begins here
float _WallReach;     // m: how deep inside a closed mesh a particle is still pushed out

// Acceleration along the unit normal at a distance from the wall, negative distances being behind it.
float3 WallForce(float3 normal, float distanceToWall, float3 velocity)
{
    const float push = _WallStiffness * (_WallDistance - distanceToWall) - _WallDamping * dot(velocity, normal);
    return distanceToWall < _WallDistance ? normal * max(push, 0.0) : float3(0.0, 0.0, 0.0);
}

// The six inner faces of the domain box, by the same law; faces of periodic axes are no walls.
float3 DomainForce(float3 position, float3 velocity)
{
    const float3 low = position + _DomainHalfSize;
    const float3 high = _DomainHalfSize - position;
    const float3 pushLow = _WallStiffness * (_WallDistance - low) - _WallDamping * velocity;
    const float3 pushHigh = _WallStiffness * (_WallDistance - high) + _WallDamping * velocity;
    return WhereWalls(float3(low < _WallDistance) * max(pushLow, 0.0) - float3(high < _WallDistance) * max(pushHigh, 0.0));
}

// What one mesh does to a particle. Faces whose prism holds the particle add up: two at a concave edge are two walls.
// Edges and vertices count only where no face is in contact, and then the nearest alone,
// so that triangles which share an edge or a plane are not counted twice. The drags of several meshes act one after the other,
// each on the velocity that the one before left.
float3 ColliderForce(CollisionCollider collider, float3 position, float3 velocity, float reach, inout float3 drag)
{
    const bool closed = (collider.TriangleCount & COLLIDER_CLOSED) != 0u;
    const uint end = collider.FirstTriangle + (collider.TriangleCount & COLLIDER_COUNT_MASK);
    const float range = closed ? max(_WallReach, reach) : reach; // the nearest triangle decides between inside and outside
    const float3 move = velocity * _TimeStep;
    const float tie = 1e-4 * _WallDistance;
    float3 faces = float3(0.0, 0.0, 0.0);
    bool faceContact = false;
    float nearest = 1e30;
    float3 nearestOffset = float3(0.0, 0.0, 0.0);
    float3 nearestNormal = float3(0.0, 0.0, 0.0);
    float hit = 1.0;
    float3 hitNormal = float3(0.0, 0.0, 0.0);

    for (uint t = collider.FirstTriangle; t < end; t++)
    {
        const CollisionTriangle tri = _Triangles[t];
        const float3 unscaled = cross(tri.B - tri.A, tri.C - tri.A);
        const float3 normal = unscaled * rsqrt(max(dot(unscaled, unscaled), 1e-30));
        const float height = dot(position - tri.A, normal);
        if (abs(height) < range)
        {
            const float side = closed || height >= 0.0 ? 1.0 : -1.0;
            const float fraction = SegmentTriangle(position, move, tri.A, tri.B, tri.C);
            if (fraction < hit && dot(move, normal) * side < 0.0)
            {
                hit = fraction;
                hitNormal = normal * side;
            }

            bool onFace;
            const float3 offset = position - ClosestPointOnTriangle(position, tri.A, tri.B, tri.C, onFace);
            const float distanceToIt = length(offset);
            if (distanceToIt < nearest - tie)
            {
                nearest = distanceToIt;
                nearestOffset = offset;
                nearestNormal = normal;
            }
            else if (distanceToIt < nearest + tie)
            {
                nearestNormal += normal; // neighbours that share the nearest edge or vertex
            }
            if (onFace && height * side >= 0.0 && height * side < _WallDistance)
            {
                faces += WallForce(normal * side, height * side, velocity);
                faceContact = true;
            }
        }
    }

    float3 force = faces;
    const bool behind = closed && dot(nearestOffset, nearestNormal) < 0.0;
    if (behind && nearest < _WallReach)
    {
        force = WallForce(-nearestOffset / nearest, -min(nearest, _WallDistance), velocity);
    }
    else if (!faceContact && nearest < _WallDistance)
    {
        const float3 away = nearest > 0.0 ? nearestOffset / nearest : normalize(nearestNormal);
        force = WallForce(away, nearest, velocity);
    }

#if defined(FLUID_NO_SLIP)
    [branch]
    if (nearest < _DragDistance)
    {
        const float3 away = nearest > 0.0 ? nearestOffset / nearest : normalize(nearestNormal);
        drag += MeshDrag(away, behind ? 0.0 : nearest, velocity + drag * _KickStep);
    }
#endif

    // A step that would cross a face is cut at the face.
    const float missing = -dot(velocity, hitNormal) * (1.0 - hit) / _KickStep - dot(force, hitNormal);
    if (hit < 1.0 && missing > 0.0)
    {
        force += hitNormal * missing;
    }
    return force;
}

// "For each triangle: if collision detected". Meshes whose box is out of reach are skipped whole.
float3 CollisionForce(float3 position, float3 velocity)
{
    float contact = _WallDistance;
    float3 drag = float3(0.0, 0.0, 0.0);
    float3 force = DomainForce(position, velocity);
#if defined(FLUID_NO_SLIP)
    contact = max(contact, _DragDistance);
    const float3 low = position + _DomainHalfSize;
    const float3 high = _DomainHalfSize - position;
    [branch]
    if (any(min(low, high) < _DragDistance))
    {
        drag = DomainDrag(low, high, velocity);
    }
#endif
    const float reach = contact + length(velocity) * _TimeStep;
    // A loop that ends by a uniform alone is translated anew at every dispatch where a CPU draws.
    const uint count = min(_ColliderCount, asuint(reach) | 0x7FFFFFFFu);
    for (uint c = 0u; c < count; c++)
    {
        const CollisionCollider collider = _Colliders[c];
        if (all(position > collider.BoundsMin - reach) && all(position < collider.BoundsMax + reach))
        {
            force += ColliderForce(collider, position, velocity, reach, drag);
        }
    }
#if defined(FLUID_NO_SLIP)
    force = _DragDistance > 0.0 ? force + drag : force;
#endif
    return force;
}

#endif
