#ifndef SPHFLUID_BODIES
#define SPHFLUID_BODIES

// The scene's triangles as bodies, each in a frame of its own in which its triangles rest: all that does not move and has the friction
// alike is one.
// A body's cells list the triangles that intersect the cell inflated by R, so one cell serves a particle: it has every triangle
// within R. Outside the cells there is none within R.
#define BODY_MOVES 1u
#define BODY_STRETCHES 2u
#define BODY_NUMBER_SHIFT 8u // above it the number of the rigid body that the liquid moves; 0: none does

// A collider whose scale or shear changes is a rigid pose and a stretch: in the rigid frame each corner moves linearly, from S0 v to
// S1 v, where S0 and S1 are symmetric and positive definite. One that deforms has corners for the start of the frame and corners for its
// end, between which they move linearly in the rigid frame. Kernels that include this file declare
// "#pragma multi_compile_local _ FLUID_STRETCHED_BODIES", so that scenes without either do not pay for them.

// Parts of a displacement that are looked up one by one: 64 R in a frame at most, and what a particle goes itself. Mirrored by
// CollisionBodies.cs.
#if defined(FLUID_STRETCHED_BODIES)
#define BODY_MOST_PARTS 256
#else
#define BODY_MOST_PARTS 64
#endif

// Mirrored by CollisionBody.cs; 192 bytes.
struct CollisionBody
{
    // body frame to simulation space at the start of the frame, a quaternion; of a body that the liquid moves: of the step
    float4 Rotation0;
    float4 Rotation1; // at its end
    float3 Position0; // m
    uint FirstCell;   // behind _BodyCellsBegin
    float3 Position1;
    uint Flags;
    float3 GridOrigin; // m, body frame
    float CellSide;    // m
    int3 GridCounts;
    uint BodyCount; // of all, the same in each
    float3 BoundsMin; // of the triangles, m, body frame
    float Friction; // 0 free slip to 1 no slip; negative: that of the domain's faces
    float3 BoundsMax;
    float PartsPerMetre; // of a displacement in the triangles' frame: 1/(1.7 R) of a rigid body
    float3 StretchDiagonal0; // xx, yy, zz of the stretch at the start of the frame; 1 of a rigid body
    float3 StretchShear0;    // yz, zx, xy
    float3 StretchDiagonal1; // at its end
    float3 StretchShear1;
    uint EndTriangles; // how far behind a triangle that of the end of the frame is, of a body that deforms; 0: it does not
    float3 Unused;
};

#define NEEDLE_AREA 1e-3 // twice the area over the longest edge's square; mirrored by CollisionBody.cs

// Mirrored by BodyTriangle.cs; 48 bytes. Normal: unit, zero for a needle, whose plane float cannot resolve.
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
StructuredBuffer<uint> _BodyLists; // first what is known of the edges of each triangle: WallEnergy.hlsl
uint _BodyCellsBegin;     // a body has cells + 1 entries: the range of a cell in what follows
uint _CellTrianglesBegin; // indices into _BodyTriangles
float _PoseStart; // where this step begins in the frame's motion, 0 to 1
float _PoseEnd;

// Kept in the buffer: llvmpipe translates a kernel anew with every dispatch whose loops end at a constant's value.
uint BodyCount()
{
    return _Bodies[0].BodyCount;
}

// A symmetric matrix: xx, yy, zz and yz, zx, xy.
struct Stretch
{
    float3 Diagonal;
    float3 Shear;
};

struct BodyPose
{
    float4 Rotation;
    float3 Position;
#if defined(FLUID_STRETCHED_BODIES)
    Stretch Stretched; // the triangles' frame to the rigid one
    Stretch Relaxed;   // its inverse
    float Fraction;    // of the frame
    uint EndTriangles;
#endif
};

float3 Apply(Stretch s, float3 v)
{
    return s.Diagonal * v + s.Shear.zxy * v.yzx + s.Shear.yzx * v.zxy;
}

Stretch Inverse(Stretch s)
{
    Stretch cofactors;
    cofactors.Diagonal = s.Diagonal.yzx * s.Diagonal.zxy - s.Shear * s.Shear;
    cofactors.Shear = s.Shear.yzx * s.Shear.zxy - s.Diagonal * s.Shear;
    const float determinant = s.Diagonal.x * cofactors.Diagonal.x + s.Shear.z * cofactors.Shear.z + s.Shear.y * cofactors.Shear.y;
    cofactors.Diagonal /= determinant;
    cofactors.Shear /= determinant;
    return cofactors;
}

Stretch Between(Stretch a, Stretch b, float fraction)
{
    Stretch s;
    s.Diagonal = a.Diagonal * (1.0 - fraction) + b.Diagonal * fraction;
    s.Shear = a.Shear * (1.0 - fraction) + b.Shear * fraction;
    return s;
}

// The same fraction gives the same pose to the last bit, and so do 1 and the next frame's 0: a step ends where the next begins.
BodyPose PoseAt(CollisionBody body, float fraction)
{
    BodyPose pose;
    const float4 near = dot(body.Rotation0, body.Rotation1) < 0.0 ? -body.Rotation1 : body.Rotation1;
    pose.Rotation = normalize(body.Rotation0 * (1.0 - fraction) + near * fraction);
    pose.Position = body.Position0 * (1.0 - fraction) + body.Position1 * fraction;
#if defined(FLUID_STRETCHED_BODIES)
    Stretch stretch0;
    stretch0.Diagonal = body.StretchDiagonal0;
    stretch0.Shear = body.StretchShear0;
    Stretch stretch1;
    stretch1.Diagonal = body.StretchDiagonal1;
    stretch1.Shear = body.StretchShear1;
    pose.Stretched = Between(stretch0, stretch1, fraction);
    pose.Relaxed = Inverse(pose.Stretched);
    pose.Fraction = fraction;
    pose.EndTriangles = body.EndTriangles;
#endif
    return pose;
}

// A body that the liquid moves has the poses of the step, others those of the frame.
BodyPose StartPose(CollisionBody body)
{
    return PoseAt(body, body.Flags >> BODY_NUMBER_SHIFT != 0u ? 0.0 : _PoseStart);
}

BodyPose EndPose(CollisionBody body)
{
    return PoseAt(body, body.Flags >> BODY_NUMBER_SHIFT != 0u ? 1.0 : _PoseEnd);
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

// A place of the rigid frame at the end of a step that moves with the body from where it is at the start.
float3 Carried(BodyPose start, BodyPose end, float3 position)
{
#if defined(FLUID_STRETCHED_BODIES)
    return Apply(end.Stretched, Apply(start.Relaxed, position));
#else
    return position;
#endif
}

// Displacement of the body in a step, at a place of the rigid frame at its start.
float3 Displacement(BodyPose start, BodyPose end, float3 position)
{
    return ToSimulation(end, Carried(start, end, position)) - ToSimulation(start, position);
}

// Range in _BodyLists of the triangles of the cell that holds a position of the triangles' frame; empty outside the grid.
uint2 BodyCellRange(CollisionBody body, float3 position)
{
    const int3 cell = int3(floor((position - body.GridOrigin) / body.CellSide));
    uint2 range = uint2(0u, 0u);
    if (all(cell >= 0) && all(cell < body.GridCounts))
    {
        const uint index = _BodyCellsBegin + body.FirstCell + uint(cell.x + body.GridCounts.x * (cell.y + body.GridCounts.y * cell.z));
        range = _CellTrianglesBegin + uint2(_BodyLists[index], _BodyLists[index + 1u]);
    }
    return range;
}

// The displacement of a particle in a body's rigid frame during a step, looked up in parts: a cell's list reaches R beyond the cell,
// so that of a part's middle has what a part of 1.7 R can come near.
struct BodySpan
{
    float3 From;
    float3 To;
    uint Parts;
#if defined(FLUID_STRETCHED_BODIES)
    Stretch Start;
    Stretch End;
#endif
};

BodySpan SpanOf(CollisionBody body, float3 from, float3 to, BodyPose start, BodyPose end)
{
    BodySpan span;
    span.From = from;
    span.To = to;
#if defined(FLUID_STRETCHED_BODIES)
    span.Start = start.Stretched;
    span.End = end.Stretched;
    const float reach = length(Apply(end.Relaxed, to) - Apply(start.Relaxed, from));
#else
    const float reach = length(to - from);
#endif
    span.Parts = 1u + uint(min(reach * body.PartsPerMetre, float(BODY_MOST_PARTS - 1)));
    return span;
}

uint2 SpanRange(CollisionBody body, BodySpan span, uint part)
{
    const float middle = (float(part) + 0.5) / float(span.Parts);
    float3 position = span.From + (span.To - span.From) * middle;
#if defined(FLUID_STRETCHED_BODIES)
    position = Apply(Inverse(Between(span.Start, span.End, middle)), position);
#endif
    return BodyCellRange(body, position);
}

// A triangle in the rigid frame at a pose.
BodyTriangle TriangleAt(BodyPose pose, uint index)
{
    BodyTriangle tri = _BodyTriangles[index];
#if defined(FLUID_STRETCHED_BODIES)
    float3 n;
    [branch]
    if (pose.EndTriangles != 0u)
    {
        const BodyTriangle end = _BodyTriangles[index + pose.EndTriangles];
        tri.A = tri.A * (1.0 - pose.Fraction) + end.A * pose.Fraction;
        tri.B = tri.B * (1.0 - pose.Fraction) + end.B * pose.Fraction;
        tri.C = tri.C * (1.0 - pose.Fraction) + end.C * pose.Fraction;
        const float3 ab = tri.B - tri.A;
        const float3 ac = tri.C - tri.A;
        const float longest = max(dot(ab, ab), max(dot(ac, ac), dot(tri.C - tri.B, tri.C - tri.B)));
        n = cross(ab, ac);
        n = dot(n, n) > NEEDLE_AREA * NEEDLE_AREA * longest * longest ? n : float3(0.0, 0.0, 0.0);
    }
    else
    {
        tri.A = Apply(pose.Stretched, tri.A);
        tri.B = Apply(pose.Stretched, tri.B);
        tri.C = Apply(pose.Stretched, tri.C);
        n = Apply(pose.Relaxed, float3(tri.NormalX, tri.NormalY, tri.NormalZ));
    }
    const float squared = dot(n, n);
    const float scale = squared > 0.0 ? rsqrt(squared) : 0.0;
    tri.NormalX = n.x * scale;
    tri.NormalY = n.y * scale;
    tri.NormalZ = n.z * scale;
#endif
    return tri;
}

#if defined(FLUID_STRETCHED_BODIES)

// Of a triangle's corners at a place on it; they add up to 1.
float3 CornerWeights(BodyTriangle tri, float3 place)
{
    const float3 ab = tri.B - tri.A;
    const float3 ac = tri.C - tri.A;
    const float3 ap = place - tri.A;
    const float3 n = cross(ab, ac);
    const float squared = dot(n, n);
    const float b = squared > 0.0 ? saturate(dot(cross(ap, ac), n) / squared) : 0.0;
    const float c = squared > 0.0 ? min(saturate(dot(cross(ab, ap), n) / squared), 1.0 - b) : 0.0;
    return float3(1.0 - b - c, b, c);
}

float3 AtWeights(BodyTriangle tri, float3 weights)
{
    return weights.x * tri.A + weights.y * tri.B + weights.z * tri.C;
}

#endif

float3 NormalOf(BodyTriangle tri)
{
    return float3(tri.NormalX, tri.NormalY, tri.NormalZ);
}

#endif
