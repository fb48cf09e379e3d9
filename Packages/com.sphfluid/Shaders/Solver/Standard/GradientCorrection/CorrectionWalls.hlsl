#ifndef SPHFLUID_CORRECTION_WALLS
#define SPHFLUID_CORRECTION_WALLS

// What walls have to do with the correction. The mirror layers behind a wall make the moments of the liquid before it whole, but a wall
// pushes along its normal only: the moments of its layers across are a pressure that nobody exerts, for which the correction has to make
// up. A kernel that includes this file includes MeshWalls.hlsl before it.
#include "SymmetricMatrix.hlsl"

struct WallMoments
{
    SymmetricMatrix Full;   // of all layers
    SymmetricMatrix Pushed; // what of it acts
};

// Of a plane at a distance d, the second moments of its mirror layers along the normal, x, and across, y, which is their density:
//   (1/kappa) sum_l 21 z^2 (1-z)^4 (4z+1) and MirrorProfile.
float2 MirrorMoment(float d)
{
    float along = 0.0;
    for (int l = 0; l < 3; l++)
    {
        const float z = min(2.0 * max(d, 0.0) * _InverseSupport + float(l) * _MirrorSpacing, 1.0);
        const float u = (1.0 - z) * (1.0 - z);
        along += z * z * (u * u) * (4.0 * z + 1.0);
    }
    return float2(21.0 * along / _SupportRatio, MirrorProfile(d).x);
}

// One wall more, F_k = N n n + L (1 - n n), P_k = N n n: walls see each other's layers once,
//   F = F + F_k - sym(F F_k),  P = sym(P (1 - F_k)) + sym(P_k (1 - F)).
void AddWall(inout WallMoments walls, float3 n, float distance)
{
    const float2 layers = MirrorMoment(distance);
    const SymmetricMatrix full = walls.Full;
    const float3 fullAlong = Times(full, n);
    const float3 pushedAlong = Times(walls.Pushed, n);
    const float across = layers.y;
    const float more = layers.x - layers.y;
    AddScaled(walls.Pushed, walls.Pushed, -across);
    AddProduct(walls.Pushed, n, layers.x * (n - fullAlong) - more * pushedAlong);
    AddScaled(walls.Full, full, -across);
    walls.Full.Diagonal += across;
    AddProduct(walls.Full, n, more * (n - fullAlong));
}

// Those of the domain or, near triangles, the planes that the particle sees, as far as they are there: of an edge less than the planes.
WallMoments MomentsOfWalls(uint slot, float3 position)
{
    WallMoments walls = (WallMoments)0;
    [loop]
    for (uint face = 0u; face < (slot == 0u ? 6u : 0u); face++)
    {
        const uint axis = face >> 1u;
        const float3 n = float3(axis == 0u ? 1.0 : 0.0, axis == 1u ? 1.0 : 0.0, axis == 2u ? 1.0 : 0.0);
        const float distance = dot(n, (face & 1u) != 0u ? _WallsHigh - position : position - _WallsLow);
        [branch]
        if (2.0 * distance * _InverseSupport < 1.0)
        {
            AddWall(walls, n, distance);
        }
    }
#if defined(FLUID_MESH_WALLS)
    [branch]
    if (slot != 0u)
    {
        const NearWall wall = WallOf(slot, position);
        float open = 1.0;
        [unroll]
        for (uint k = 0u; k < uint(WALL_PLANES); k++)
        {
            AddWall(walls, wall.Planes[k].xyz, wall.Planes[k].w);
            open *= 1.0 - MirrorProfile(wall.Planes[k].w).x;
        }
        const float solid = saturate(wall.Share / max(1.0 - open, 1e-6));
        walls.Full = Scaled(walls.Full, solid);
        walls.Pushed = walls.Full; // see WallFade
    }
#endif
    return walls;
}

// How much of the correction acts: before triangles, whose planes tell too little of their layers, none within R/2 and all beyond R.
float WallFade(uint slot, float3 position)
{
    float nearest = 1.0 / _InverseSupport;
#if defined(FLUID_MESH_WALLS)
    [branch]
    if (slot != 0u)
    {
        const NearWall wall = WallOf(slot, position);
        nearest = min(wall.Planes[0].w, min(wall.Planes[1].w, wall.Planes[2].w));
    }
#endif
    return saturate(2.0 * nearest * _InverseSupport - 1.0);
}

#endif
