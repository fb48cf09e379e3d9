#ifndef SPHFLUID_PAIR_FORCES
#define SPHFLUID_PAIR_FORCES

// What neighbours do to a particle: symmetric pressure, the parting of close pairs and laminar viscosity (Morris et al. 1997),
//   a_i = -(1/M) (m sum_j (P_i + P_j) grad W - (2 nu m / rho0) sum_j (W'/r) (v_i - v_j)).
// A kernel that includes this file has the keywords FLUID_PERIODIC, or defines it, and FLUID_MESH_WALLS; it may have
// FLUID_GRADIENT_CORRECTION.
#include "../Cells/CellRows.hlsl"
#include "../Cells/NeighbourList.hlsl"
#include "../Cells/Wendland.hlsl"
#include "../Cells/ClosePairs.hlsl"
#include "../Cells/MeshWalls.hlsl"

StructuredBuffer<float4> _PositionTerms; // present place, P
StructuredBuffer<float4> _Velocities;
float _SlopeFactor;     // m 210 / (pi R^5) / M
float _ViscosityFactor; // 2 nu / rho0
float _LeastSeparation; // m, for particles that share a place

#if defined(FLUID_GRADIENT_CORRECTION)
#include "GradientCorrection/CorrectedPressure.hlsl"
#endif

// What neighbours push and drag, without the factor.
struct PairSums
{
    float3 Push;
    float3 Drag; // without the viscosity
    float Weight; // of the drag: the sum of the slopes
#if defined(FLUID_GRADIENT_CORRECTION)
    CorrectedSums Corrected;
#endif
};

PairSums NoPairs(uint id, float3 position)
{
    PairSums sums = (PairSums)0;
#if defined(FLUID_GRADIENT_CORRECTION)
    sums.Corrected = OwnCorrection(id, position);
#endif
    return sums;
}

bool ShareAPlace(float distanceSquared)
{
    return distanceSquared < 1e-2 * _LeastSeparation * _LeastSeparation;
}

// Where two particles share a place pressure has no direction: they part along x, by their order.
float Apart(uint id, uint other, float distanceSquared)
{
    const float apart = id < other ? _LeastSeparation : -_LeastSeparation;
    return ShareAPlace(distanceSquared) ? apart : 0.0;
}

// Adds a neighbour and returns r^2. Of one that is not seen it adds nothing.
float AddNeighbour(inout PairSums sums, uint j, bool sees, float3 position, float3 velocity, float pressure)
{
    const float4 place = _PositionTerms[j];
    const float3 relativeVelocity = velocity - _Velocities[j].xyz;
    const float3 d = Separation(position, place.xyz);
    const float distanceSquared = SeenSquared(sees, dot(d, d));
    const float slope = WendlandSlope(distanceSquared);
    sums.Push += (slope * (pressure + place.w) + ClosePair(distanceSquared, dot(d, relativeVelocity))) * d;
    sums.Drag += slope * relativeVelocity;
    sums.Weight += slope;
#if defined(FLUID_GRADIENT_CORRECTION)
    AddCorrected(sums.Corrected, j, pressure, place.w, slope, d, relativeVelocity);
#endif
    return distanceSquared;
}

// What is missing of one that shares the place, where the slope and the weight of close pairs are 1.
void PartFromPlace(inout PairSums sums, uint id, uint j, bool sees, float3 position, float pressure)
{
    const float4 place = _PositionTerms[j];
    const float3 d = Separation(position, place.xyz);
    sums.Push.x += (pressure + place.w + _ClosePairs.y) * Apart(id, j, SeenSquared(sees, dot(d, d)));
}

PairSums ListedNeighbours(uint id, uint count, float3 position, float3 velocity, float pressure)
{
    PairSums sums = NoPairs(id, position);
    float leastSquared = 1.0 / (_InverseSupport * _InverseSupport); // to the nearest
    FOR_EACH_RUN(id, count, run)
    {
        const ListPair pair = NextPair(run);
        const float firstSquared = AddNeighbour(sums, pair.First, pair.SeesFirst, position, velocity, pressure);
        const float secondSquared = AddNeighbour(sums, pair.Second, pair.SeesSecond, position, velocity, pressure);
        leastSquared = min(min(firstSquared, secondSquared), leastSquared);
    }
    FOR_EACH_RUN(id, ShareAPlace(leastSquared) ? count : 0u, again)
    {
        bool sees;
        const uint j = NextListed(again, sees);
        PartFromPlace(sums, id, j, sees, position, pressure);
    }
    return sums;
}

#if defined(FLUID_GRADIENT_CORRECTION)

// The images of the particle and of those on its list; few particles have any.
void AddFaces(inout CorrectedSums sums, uint id, uint count, float3 position, float3 velocity, float pressure)
{
    ListRun run = BeforeRuns(id, count);
    bool goesOn = sums.Images.Faces != 0u;
    while (goesOn)
    {
        goesOn = (run.Head & LIST_GOES_ON) != 0u;
        [branch]
        if (goesOn)
        {
            OpenRun(run);
        }
        else // a run of the particle itself
        {
            run.Head = LIST_PAIR;
            run.Half = 16u;
        }
        while (run.Head >= LIST_PAIR)
        {
            bool sees;
            const uint next = NextListed(run, sees);
            const uint j = goesOn ? next : id;
            const float4 place = _PositionTerms[j];
            const float3 d = Separation(position, place.xyz);
            [branch]
            if (SeenSquared(sees || !goesOn, dot(d, d)) * _InverseSupport * _InverseSupport < 1.0)
            {
                AddImages(sums, j, pressure, place.w, d, velocity, _Velocities[j].xyz);
            }
        }
    }
    [branch]
    if (sums.Images.Faces != 0u)
    {
        YieldFaces(sums, WallsOf(WallSlot(id), position).Gradient);
    }
}

#endif

PairSums NeighbourSums(uint id, float3 position, float3 velocity, float pressure)
{
    const uint count = _Neighbours[_NeighbourCountsBegin + id];
    const bool listed = count <= _ListLength;
    PairSums sums = ListedNeighbours(id, listed ? count : 0u, position, velocity, pressure);
    const uint cell = SortedCell(id, !listed);
    FOR_EACH_NEAR_IF(!listed, CellOf(cell), other)
    {
        const float3 place = _PositionTerms[other].xyz;
        const float3 d = Separation(position, place);
        [branch]
        if (IsUnlistedPair(dot(d, d) < 1.0 / (_InverseSupport * _InverseSupport) && other != id, id, position, other, place, d))
        {
            const float3 parted = position + float3(Apart(id, other, dot(d, d)), 0.0, 0.0);
            AddNeighbour(sums, other, true, parted, velocity, pressure);
#if defined(FLUID_GRADIENT_CORRECTION)
            AddImages(sums.Corrected, other, pressure, _PositionTerms[other].w, d, velocity, _Velocities[other].xyz);
#endif
        }
    }
#if defined(FLUID_GRADIENT_CORRECTION)
    AddFaces(sums.Corrected, id, listed ? count : 0u, position, velocity, pressure);
    sums.Push += sums.Corrected.Push;
#endif
    return sums;
}

// The push of the images square to the faces, without the factor.
float3 PushOfImages(PairSums sums)
{
#if defined(FLUID_GRADIENT_CORRECTION)
    return sums.Corrected.FromFaces;
#else
    return float3(0.0, 0.0, 0.0);
#endif
}

// The end of the pairs' work, when it is known by how much walls change the density, 1/m.
void EndPairs(uint id, PairSums sums, float3 wallGradient)
{
#if defined(FLUID_GRADIENT_CORRECTION)
    MoveOffset(id, sums.Corrected, wallGradient);
#endif
}

#endif
