#ifndef SPHFLUID_BODIES
#define SPHFLUID_BODIES

// The scene's triangles as bodies, each in a frame of its own in which its triangles rest: all that does not move and rubs
// alike is one.
// A body's cells list the triangles that meet the cell inflated by R, so one cell serves a particle: it has every triangle
// within R. Outside the cells there is none within R.
#define BODY_MOVES 1u

// Of a way: 64 R in a frame at most, and what a particle goes itself.
#define BODY_MOST_PARTS 64

// Mirrored by CollisionBody.cs; 128 bytes.
struct CollisionBody
{
    float4 Rotation0; // body frame to simulation space at the start of the frame, a quaternion
    float4 Rotation1; // at its end
    float3 Position0; // m
    uint FirstCell;   // of _BodyCells
    float3 Position1;
    uint Flags;
    float3 GridOrigin; // m, body frame
    float CellSide;    // m
    int3 GridCounts;
    uint BodyCount; // of all, the same in each
    float3 BoundsMin; // of the triangles, m, body frame
    float Friction; // 0 free slip to 1 no slip; negative: that of the domain's faces
    float3 BoundsMax;
    float Pad;
};

// Mirrored by BodyTriangle.cs; 48 bytes. Normal: unit, zero for a needle, whose plane float cannot tell.
struct BodyTriangle
{
    float3 A;
    float NormalX;
    float3 B;
    float NormalY;
    float3 C;
    float NormalZ;
};

StructuredBuffer<CollisionBody> _Bodies;
StructuredBuffer<BodyTriangle> _BodyTriangles;
StructuredBuffer<uint> _BodyCells;     // a body has cells + 1 entries: the range of a cell in _CellTriangles
StructuredBuffer<uint> _CellTriangles; // indices into _BodyTriangles
float _PoseStart; // where this step begins in the frame's motion, 0 to 1
float _PoseEnd;
float _BodyPartsPerMetre; // 1/(1.7 R)

// Kept in the buffer: llvmpipe translates a kernel anew with every dispatch whose loops end at a constant's value.
uint BodyCount()
{
    return _Bodies[0].BodyCount;
}

struct BodyPose
{
    float4 Rotation;
    float3 Position;
};

// The same fraction gives the same pose to the last bit, and so do 1 and the next frame's 0: a step ends where the next begins.
BodyPose PoseAt(CollisionBody body, float fraction)
{
    BodyPose pose;
    const float4 near = dot(body.Rotation0, body.Rotation1) < 0.0 ? -body.Rotation1 : body.Rotation1;
    pose.Rotation = normalize(body.Rotation0 * (1.0 - fraction) + near * fraction);
    pose.Position = body.Position0 * (1.0 - fraction) + body.Position1 * fraction;
    return pose;
}

float3 Rotate(float4 q, float3 v)
{
    const float3 t = 2.0 * cross(q.xyz, v);
    return v + q.w * t + cross(q.xyz, t);
}

float3 ToBody(BodyPose pose, float3 position)
{
    return Rotate(float4(-pose.Rotation.xyz, pose.Rotation.w), position - pose.Position);
}

float3 ToSimulation(BodyPose pose, float3 position)
{
    return Rotate(pose.Rotation, position) + pose.Position;
}

// Range in _CellTriangles of the cell that holds a position of the body's frame; empty outside the grid.
uint2 BodyCellRange(CollisionBody body, float3 position)
{
    const int3 cell = int3(floor((position - body.GridOrigin) / body.CellSide));
    uint2 range = uint2(0u, 0u);
    if (all(cell >= 0) && all(cell < body.GridCounts))
    {
        const uint index = body.FirstCell + uint(cell.x + body.GridCounts.x * (cell.y + body.GridCounts.y * cell.z));
        range = uint2(_BodyCells[index], _BodyCells[index + 1u]);
    }
    return range;
}

// Parts of a way that are looked up one by one: a cell's list reaches R beyond the cell, so that of a part's middle has what a
// part of 1.7 R can come near.
uint WayParts(float3 from, float3 to)
{
    return 1u + uint(min(length(to - from) * _BodyPartsPerMetre, float(BODY_MOST_PARTS - 1)));
}

uint2 BodyWayRange(CollisionBody body, float3 from, float3 to, uint part, uint parts)
{
    return BodyCellRange(body, from + (to - from) * ((float(part) + 0.5) / float(parts)));
}

float3 NormalOf(BodyTriangle tri)
{
    return float3(tri.NormalX, tri.NormalY, tri.NormalZ);
}

#endif
