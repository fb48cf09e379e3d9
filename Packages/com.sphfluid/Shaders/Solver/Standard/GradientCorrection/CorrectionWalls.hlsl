#ifndef SPHFLUID_CORRECTION_WALLS
#define SPHFLUID_CORRECTION_WALLS

// What walls have to do with the correction. A kernel that includes this file includes MeshWalls.hlsl before it.
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

void AddPlane(inout SymmetricMatrix moment, float3 normal, float distance)
{
    const float2 layers = MirrorMoment(distance);
    moment.Diagonal += layers.y + (layers.x - layers.y) * normal * normal;
    moment.Shear += (layers.x - layers.y) * normal.yzx * normal.zxy;
}

SymmetricMatrix FaceMoment(float3 position)
{
    SymmetricMatrix moment = (SymmetricMatrix)0;
    [unroll]
    for (int axis = 0; axis < 3; axis++)
    {
        const float2 layers = MirrorMoment(position[axis] - _WallsLow[axis]) + MirrorMoment(_WallsHigh[axis] - position[axis]);
        moment.Diagonal += layers.y;
        moment.Diagonal[axis] += layers.x - layers.y;
    }
    return moment;
}

// What walls add to the moment: those of the domain or, near triangles, the planes that the particle sees.
SymmetricMatrix WallMoment(uint slot, float3 position)
{
    SymmetricMatrix moment = FaceMoment(position);
#if defined(FLUID_MESH_WALLS)
    [branch]
    if (slot != 0u)
    {
        const NearWall wall = WallOf(slot, position);
        moment = (SymmetricMatrix)0;
        [unroll]
        for (uint k = 0u; k < uint(WALL_PLANES); k++)
        {
            AddPlane(moment, wall.Planes[k].xyz, wall.Planes[k].w);
        }
    }
#endif
    return moment;
}

// How much of the correction acts: none within R/2 of a wall, all beyond R. At walls, which push without it, it would feed in energy.
float WallFade(uint slot, float3 position)
{
    const float3 faces = min(position - _WallsLow, _WallsHigh - position);
    float distance = min(faces.x, min(faces.y, faces.z));
#if defined(FLUID_MESH_WALLS)
    [branch]
    if (slot != 0u)
    {
        const NearWall wall = WallOf(slot, position);
        distance = min(distance, min(wall.Planes[0].w, min(wall.Planes[1].w, wall.Planes[2].w)));
    }
#endif
    return saturate(2.0 * distance * _InverseSupport - 1.0);
}

#endif
