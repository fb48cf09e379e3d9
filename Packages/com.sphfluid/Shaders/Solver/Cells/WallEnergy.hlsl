#ifndef SPHFLUID_WALL_ENERGY
#define SPHFLUID_WALL_ENERGY

// The share of a particle's kernel that lies behind walls, triangles and faces of the domain together: one function of place, whose
// gradient is the walls' push, so that walls at rest do no work. Lengths are over R, gradients and Hessians per R and R^2.
#include "TriangleSweep.hlsl"
#include "EdgeShadow.hlsl"
#include "NearTriangles.hlsl"
#include "MeshWalls.hlsl"

// of each triangle: three bits for edges inside of a plane, the others here, and above them the number of its surface

#define EDGES_TURNED 8u // its corners run the other way than those of its surface
#define EDGES_DEEP_BEHIND 16u // the solid is deep on the side from which its normal looks, and on that to which it looks
#define EDGES_DEEP_AHEAD 32u
#define EDGES_SURFACE 8u

// The planes that each thread has found, those of the same turn side by side: normal towards the particle, zero for none, and distance [m];
// the body, NO_BODY for a face of the domain; and what its wall has of the gradient, for bodies and for rectangles that measure. Here they
// cost no registers in the loops over triangles.
groupshared float4 feltPlanes[WALL_PLANES * CELL_THREADS];
groupshared uint feltBodies[WALL_PLANES * CELL_THREADS];
groupshared float3 feltPushes[WALL_PLANES * CELL_THREADS];

#define NO_BODY 0xffffffffu

uint FeltAt(uint thread, uint plane)
{
    return plane * CELL_THREADS + thread;
}

void FeelNothing(uint thread)
{
    [unroll]
    for (uint k = 0u; k < uint(WALL_PLANES); k++)
    {
        feltPlanes[FeltAt(thread, k)] = float4(0.0, 0.0, 0.0, 1.0 / _InverseSupport);
        feltBodies[FeltAt(thread, k)] = NO_BODY;
        feltPushes[FeltAt(thread, k)] = float3(0.0, 0.0, 0.0);
    }
}

// Of the domain: it stands for triangles that lie in it or behind it.
#define FACE_TOLERANCE 0.05 // dx

bool IsBehindFace(float3 a, float3 b, float3 c)
{
    const float tolerance = FACE_TOLERANCE * _MirrorSpacing / _InverseSupport;
    return any(max(a, max(b, c)) < _WallsLow + tolerance) || any(min(a, min(b, c)) > _WallsHigh - tolerance);
}

struct SeenTriangle
{
    float3 A; // relative to the particle, over R, in simulation space
    float3 B;
    float3 C;
    float3 Normal;
    float Height; // of the particle over its plane; 0: it takes no part
};

SeenTriangle Seen(BodyPose pose, bool moves, uint index, float3 position)
{
    const BodyTriangle tri = TriangleAt(pose, index);
    const float3 a = moves ? ToSimulation(pose, tri.A) : tri.A;
    const float3 b = moves ? ToSimulation(pose, tri.B) : tri.B;
    const float3 c = moves ? ToSimulation(pose, tri.C) : tri.C;
    SeenTriangle seen;
    seen.A = (a - position) * _InverseSupport;
    seen.B = (b - position) * _InverseSupport;
    seen.C = (c - position) * _InverseSupport;
    seen.Normal = moves ? Rotate(pose.Rotation, NormalOf(tri)) : NormalOf(tri);
    const float height = -dot(seen.A, seen.Normal);
    const float3 apart = max(max(min(seen.A, min(seen.B, seen.C)), -max(seen.A, max(seen.B, seen.C))), 0.0);
    const bool isNear = abs(height) < SHADOW_REACH && dot(apart, apart) < SHADOW_REACH * SHADOW_REACH &&
        dot(seen.Normal, seen.Normal) > 0.5;
    seen.Height = isNear && !IsBehindFace(a, b, c) ? height : 0.0;
    return seen;
}

uint EdgesOf(uint place)
{
    return _BodyLists[_BodyLists[place]];
}

uint SurfaceOf(uint place)
{
    return EdgesOf(place) >> EDGES_SURFACE;
}

// The side of a surface that a particle is on, by the triangle that is nearest: 1 or -1, as its corners run; 0 out of reach. end: of the
// surface's triangles; of these those that take no part are passed over from here on.
float SideOf(BodyPose pose, bool moves, NearTriangles near, uint begin, out uint end, float3 position)
{
    const uint surface = SurfaceOf(begin);
    bool sees = false; // a triangle from the side of its corners' run, and one from the other
    bool seesBack = false;
    end = begin;
    bool isSame = true;
    [loop]
    while (isSame)
    {
        const float height = Seen(pose, moves, _BodyLists[end], position).Height;
        if (height == 0.0)
        {
            PassOver(near, end);
        }
        const bool isFront = (height > 0.0) == ((EdgesOf(end) & EDGES_TURNED) == 0u);
        sees = sees || height != 0.0 && isFront;
        seesBack = seesBack || height != 0.0 && !isFront;
        end = NextNear(near, end + 1u);
        isSame = end < near.Range.y && SurfaceOf(min(end, near.Range.y - 1u)) == surface;
    }
    float nearest = SHADOW_REACH * SHADOW_REACH;
    float side = sees ? 1.0 : seesBack ? -1.0 : 0.0; // all look one way
    float highest = 0.0;
    [loop]
    for (uint t = NextNear(near, begin); t < (sees && seesBack ? end : begin); t = NextNear(near, t + 1u))
    {
        const uint index = _BodyLists[t];
        const SeenTriangle seen = Seen(pose, moves, index, position);
        [branch]
        if (seen.Height != 0.0)
        {
            BodyTriangle tri = (BodyTriangle)0;
            tri.A = seen.A;
            tri.B = seen.B;
            tri.C = seen.C;
            const float3 r = FromTriangle(float3(0.0, 0.0, 0.0), tri);
            const float squared = dot(r, r);
            const bool isNearer = squared < nearest * 0.9999;
            // Of those that share the nearest edge or corner the one that is seen steepest tells the side.
            if (isNearer || (squared < nearest * 1.0001 && abs(seen.Height) > highest))
            {
                nearest = min(nearest, squared);
                highest = abs(seen.Height);
                side = (seen.Height > 0.0) == ((_BodyLists[index] & EDGES_TURNED) == 0u) ? 1.0 : -1.0;
            }
        }
    }
    return side;
}

void Add(inout Shadow sum, Shadow part)
{
    sum.Value += part.Value;
    sum.Gradient += part.Gradient;
    sum.Diagonal += part.Diagonal;
    sum.Shear += part.Shear;
}

float3 HessianTimes(Shadow shadow, float3 v)
{
    return shadow.Diagonal * v + shadow.Shear.zxy * v.yzx + shadow.Shear.yzx * v.zxy;
}

// What is left free of something behind walls, 1 - share, by its logarithm: what several leave is the sum.
Shadow Free(Shadow shadow)
{
    const float left = 1.0 / (1.0 - shadow.Value);
    Shadow free;
    free.Value = log(1.0 - shadow.Value);
    free.Gradient = -left * shadow.Gradient;
    free.Diagonal = -left * shadow.Diagonal - free.Gradient * free.Gradient;
    free.Shear = -left * shadow.Shear - free.Gradient.yzx * free.Gradient.zxy;
    return free;
}

Shadow Behind(Shadow free)
{
    const float left = exp(free.Value);
    Shadow shadow;
    shadow.Value = 1.0 - left;
    shadow.Gradient = -left * free.Gradient;
    shadow.Diagonal = -left * (free.Diagonal + free.Gradient * free.Gradient);
    shadow.Shear = -left * (free.Shear + free.Gradient.yzx * free.Gradient.zxy);
    return shadow;
}

void AddProduct(inout Shadow sum, float factor, float3 a, float3 b)
{
    sum.Diagonal += factor * a * b;
    sum.Shear += 0.5 * factor * (a.yzx * b.zxy + a.zxy * b.yzx);
}

// What is behind triangles or a face of the domain: of walls square to each other all but the product, of walls that look the same way the
// larger, between them (a + b)/2 + sqrt((a - b)^2/4 + sin^4 ab(1 - a)(1 - b)), which in the edge of a wedge of any angle is right within
// 0.027. turning: the gradient of cosine. ofMesh: how much of the triangles' gradient is in that of both.
Shadow Joined(Shadow mesh, Shadow face, float cosine, float3 turning, out float ofMesh, out bool holds)
{
    const float c = saturate(cosine);
    const float sine2 = 1.0 - c * c;
    const float k = sine2 * sine2;
    const float3 kGradient = -4.0 * c * sine2 * turning;
    const float a = mesh.Value;
    const float b = face.Value;
    const float pa = a * (1.0 - a);
    const float pb = b * (1.0 - b);
    const float root = max(sqrt(0.25 * (a - b) * (a - b) + k * pa * pb), 1e-4);
    // Of what is under the root, D: halves of first derivatives over the root.
    const float da = 0.5 * (0.5 * (a - b) + k * pb * (1.0 - 2.0 * a)) / root;
    const float db = 0.5 * (0.5 * (b - a) + k * pa * (1.0 - 2.0 * b)) / root;
    const float dk = 0.5 * pa * pb / root;
    Shadow both = (Shadow)0;
    both.Value = 0.5 * (a + b) + root;
    ofMesh = 0.5 + da;
    both.Gradient = ofMesh * mesh.Gradient + (0.5 + db) * face.Gradient + dk * kGradient;
    both.Diagonal = ofMesh * mesh.Diagonal + (0.5 + db) * face.Diagonal;
    both.Shear = ofMesh * mesh.Shear + (0.5 + db) * face.Shear;
    const float half = 0.5 / root;
    AddProduct(both, (0.5 - 2.0 * k * pb) * half - da * da / root, mesh.Gradient, mesh.Gradient);
    AddProduct(both, (0.5 - 2.0 * k * pa) * half - db * db / root, face.Gradient, face.Gradient);
    AddProduct(both, -dk * dk / root, kGradient, kGradient);
    AddProduct(both, 2.0 * ((-0.5 + k * (1.0 - 2.0 * a) * (1.0 - 2.0 * b)) * half - da * db / root), mesh.Gradient, face.Gradient);
    AddProduct(both, 2.0 * (pb * (1.0 - 2.0 * a) * half - da * dk / root), mesh.Gradient, kGradient);
    AddProduct(both, 2.0 * (pa * (1.0 - 2.0 * b) * half - db * dk / root), face.Gradient, kGradient);
    // how far it goes along the way, against how wide the bend is
    const float3 bent = (1.0 - k) * GONE_WALLED * (mesh.Gradient - face.Gradient);
    holds = dot(bent, bent) < 4.0 * root * root && dk * length(kGradient) < 0.01 * length(both.Gradient);
    return both;
}

Shadow Scaled(Shadow shadow, float factor)
{
    shadow.Value *= factor;
    shadow.Gradient *= factor;
    shadow.Diagonal *= factor;
    shadow.Shear *= factor;
    return shadow;
}

// What is behind the planes of triangles as half-spaces: the sum less what two share, L0 L1 where they are square to each other and
// sin^2 of it where they look against each other; a plane that looks the same way as a nearer one is hidden but for sin^2.
// Worked example: two floors, one under the other, and a wall, each 1/2: 3/4. A wedge of 40 degrees: 0.90, by the angle 0.89.
// pushes: what each plane has of the gradient.
Shadow PlanesShadow(uint thread, out float3 pushes[WALL_PLANES])
{
    float3 normals[WALL_PLANES];
    float3 values;
    float3 slopes;
    float3 bends;
    [unroll]
    for (uint plane = 0u; plane < uint(WALL_PLANES); plane++)
    {
        const bool isThere = feltBodies[FeltAt(thread, plane)] != NO_BODY; // else it is a face of the domain, or none
        const float4 felt = feltPlanes[FeltAt(thread, plane)];
        const Profile profile = ProfileAt(isThere ? felt.w * _InverseSupport : 1.0);
        normals[plane] = isThere ? felt.xyz : float3(0.0, 0.0, 0.0);
        values[plane] = profile.Value;
        slopes[plane] = profile.Slope;
        bends[plane] = profile.Bend;
    }
    const float3 cosines = float3(dot(normals[1], normals[2]), dot(normals[2], normals[0]), dot(normals[0], normals[1]));
    const float3 sines2 = saturate(1.0 - cosines * cosines);
    const float3 hidden = cosines > 0.0 ? sines2 : float3(1.0, 1.0, 1.0);
    const float3 overlap = cosines > 0.0 ? float3(1.0, 1.0, 1.0) : sines2;
    const float3 inSight = float3(1.0, hidden.z, hidden.x * hidden.y);
    values *= inSight;
    slopes *= inSight;
    bends *= inSight;
    const float ofAll = overlap.x * overlap.y * overlap.z;
    const float3 pairs = overlap - ofAll * values; // of two planes, by the third
    const float3 rates = 1.0 - overlap.yzx * values.zxy - pairs.zxy * values.yzx;
    Shadow shadow = (Shadow)0;
    shadow.Value = values.x + values.y + values.z - dot(overlap, values.yzx * values.zxy) + ofAll * values.x * values.y * values.z;
    [unroll]
    for (uint k = 0u; k < uint(WALL_PLANES); k++)
    {
        const uint next = (k + 1u) % uint(WALL_PLANES);
        const uint last = (k + 2u) % uint(WALL_PLANES);
        pushes[k] = rates[k] * slopes[k] * normals[k];
        shadow.Gradient += pushes[k];
        AddProduct(shadow, rates[k] * bends[k], normals[k], normals[k]);
        AddProduct(shadow, -2.0 * pairs[k] * slopes[next] * slopes[last], normals[next], normals[last]);
    }
    return shadow;
}

// Surfaces that overlap hide each other, which their sum does not know: it is no more than what the planes have that are felt, and no less
// than what one surface has by itself. most: the largest of the surfaces.
Shadow Bounded(uint thread, Shadow sum, float most)
{
    float3 pushes[WALL_PLANES];
    const Shadow planes = PlanesShadow(thread, pushes);
    const float excess = sum.Value - planes.Value;
    const float kept = excess > 0.0 ? saturate((most - planes.Value) / max(excess, 1e-6)) : 1.0; // of the excess
    Shadow shadow = Scaled(planes, 1.0 - kept);
    Add(shadow, Scaled(sum, kept));
    [unroll]
    for (uint k = 0u; k < uint(WALL_PLANES); k++)
    {
        feltPushes[FeltAt(thread, k)] = lerp(pushes[k], feltPushes[FeltAt(thread, k)], kept);
    }
    return shadow;
}

// Of the triangles of all bodies. A surface is seen from the side that the particle is on: of its other side what belongs to a deep solid
// ends the solid and takes away what is behind it, so that round an edge nothing comes or goes at once; the back of a thin plate is left
// out. Each triangle's push is that of the plane of its body that looks most along it.
Shadow TriangleShadow(uint thread, float3 position)
{
    Shadow sum = (Shadow)0;
    uint word = 0u;
    float most = 0.0;
    [loop]
    for (uint b = 0u; b < BodyCount(); b++)
    {
        const CollisionBody body = _Bodies[b];
        const bool moves = (body.Flags & BODY_MOVES) != 0u;
        const BodyPose pose = HerePose(body);
        const float3 x = moves ? ToBody(pose, position) : position;
        const uint2 range = NearRange(body, pose, x);
        const NearTriangles near = NearOf(range, word, thread);
        word = WordBehind(near);
        uint begin = NextNear(near, range.x);
        [loop]
        while (begin < range.y)
        {
            uint end;
            const float side = SideOf(pose, moves, near, begin, end, position);
            const float before = sum.Value;
            [loop]
            for (uint t = NextNear(near, begin); t < (side != 0.0 ? end : begin); t = NextNear(near, t + 1u))
            {
                const uint index = _BodyLists[t];
                const uint edges = _BodyLists[index];
                const SeenTriangle seen = Seen(pose, moves, index, position);
                const float own = (edges & EDGES_TURNED) == 0u ? side : -side; // of its corners as they run
                const float facing = seen.Height > 0.0 ? 1.0 : -1.0;
                const bool endsSolid = (edges & (own > 0.0 ? EDGES_DEEP_BEHIND : EDGES_DEEP_AHEAD)) != 0u;
                [branch]
                if (seen.Height != 0.0 && (facing == own || endsSolid))
                {
                    const float3 n = facing * seen.Normal;
                    const bool turns = facing < 0.0;
                    const uint inPlane = turns ? ((edges & 1u) << 2u) | (edges & 2u) | ((edges >> 2u) & 1u) : edges & 7u;
                    const Shadow part = Scaled(ShadowOf(seen.A, turns ? seen.C : seen.B, turns ? seen.B : seen.C, n,
                        max(abs(seen.Height), 1e-4 * _MirrorSpacing), inPlane), facing * own);
                    Add(sum, part);
                    float3 along;
                    [unroll]
                    for (uint k = 0u; k < uint(WALL_PLANES); k++)
                    {
                        along[k] = dot(feltPlanes[FeltAt(thread, k)].xyz, n) + (feltBodies[FeltAt(thread, k)] == b ? 4.0 : 0.0);
                    }
                    const uint plane = along.x >= along.y && along.x >= along.z ? 0u : along.y >= along.z ? 1u : 2u;
                    feltPushes[FeltAt(thread, plane)] += part.Gradient;
                }
            }
            most = max(most, sum.Value - before);
            begin = end;
        }
    }
    [branch]
    if (sum.Value > most)
    {
        sum = Bounded(thread, sum, most);
    }
    return sum;
}

bool _HasMirrors; // the faces of the domain: images stand for them

// With the faces of the domain. faces: what they have of the gradient. holds: the Hessian is that of the whole.
Shadow WithFaces(uint thread, Shadow mesh, float3 position, out float3 faces, out bool holds)
{
    holds = true;
    const float steep = max(length(mesh.Gradient), 1e-6);
    const float3 normal = -mesh.Gradient / steep; // towards the liquid: the share falls along it
    const float3 low = (position - _WallsLow) * _InverseSupport;
    const float3 high = (_WallsHigh - position) * _InverseSupport;
    Shadow whole = mesh;
    float left = 1.0;
    [branch]
    if (!_HasMirrors && any(min(low, high) < SHADOW_REACH))
    {
        mesh.Value = min(mesh.Value, 0.95); // triangles that lie behind each other add up to more than all
        const Shadow meshFree = Free(mesh);
        Shadow free = meshFree;
        [loop]
        for (uint face = 0u; face < 6u; face++)
        {
            const uint axis = face >> 1u;
            const float3 along = float3(axis == 0u ? 1.0 : 0.0, axis == 1u ? 1.0 : 0.0, axis == 2u ? 1.0 : 0.0);
            const bool isHigh = (face & 1u) != 0u;
            const float d = max(dot(along, isHigh ? high : low), 1e-3);
            [branch]
            if (d < SHADOW_REACH)
            {
                const float3 n = isHigh ? -along : along;
                const Profile profile = PlaneProfile(d);
                Shadow own = (Shadow)0;
                own.Value = profile.Value;
                own.Gradient = profile.Slope * n;
                own.Diagonal = profile.Bend * along;
                const float cosine = dot(normal, n);
                float ofMesh;
                bool bothHold;
                const Shadow both = Joined(mesh, own, cosine, -HessianTimes(mesh, n - cosine * normal) / steep, ofMesh, bothHold);
                const Shadow bothFree = Free(both);
                free.Value += bothFree.Value - meshFree.Value;
                free.Gradient += bothFree.Gradient - meshFree.Gradient;
                free.Diagonal += bothFree.Diagonal - meshFree.Diagonal;
                free.Shear += bothFree.Shear - meshFree.Shear;
                left += ofMesh * (1.0 - mesh.Value) / (1.0 - both.Value) - 1.0;
                holds = holds && bothHold;
            }
        }
        whole = Behind(free);
        left *= (1.0 - whole.Value) / (1.0 - mesh.Value);
    }
    faces = whole.Gradient;
    [unroll]
    for (uint k = 0u; k < uint(WALL_PLANES); k++)
    {
        feltPushes[FeltAt(thread, k)] *= left;
        faces -= feltPushes[FeltAt(thread, k)];
    }
    return whole;
}

#endif
