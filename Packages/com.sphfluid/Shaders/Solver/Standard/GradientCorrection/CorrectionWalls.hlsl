#ifndef SPHFLUID_CORRECTION_WALLS
#define SPHFLUID_CORRECTION_WALLS

// What triangles have to do with the correction. The mirror layers behind their planes make the moments of the liquid before them whole;
// the planes tell too little of the layers for more. A kernel that includes this file includes MeshWalls.hlsl before it.
#include "SymmetricMatrix.hlsl"

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

// One plane more, F_k = N n n + L (1 - n n): planes see each other's layers once, F = F + F_k - sym(F F_k).
void AddPlane(inout SymmetricMatrix layers, float3 n, float distance)
{
    const float2 own = MirrorMoment(distance);
    const float3 along = Times(layers, n);
    AddScaled(layers, layers, -own.y);
    layers.Diagonal += own.y;
    AddProduct(layers, n, (own.x - own.y) * (n - along));
}

// Of the planes that a particle near triangles sees, as far as they are there: of an edge less than the planes.
SymmetricMatrix MomentOfPlanes(uint slot, float3 position)
{
    SymmetricMatrix layers = (SymmetricMatrix)0;
#if defined(FLUID_MESH_WALLS)
    [branch]
    if (slot != 0u)
    {
        const NearWall wall = WallOf(slot, position);
        float open = 1.0;
        [unroll]
        for (uint k = 0u; k < uint(WALL_PLANES); k++)
        {
            AddPlane(layers, wall.Planes[k].xyz, wall.Planes[k].w);
            open *= 1.0 - MirrorProfile(wall.Planes[k].w).x;
        }
        layers = Scaled(layers, saturate(wall.Share / max(1.0 - open, 1e-6)));
    }
#endif
    return layers;
}

// How much of the correction acts: before triangles none within R/2 and all beyond R.
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
