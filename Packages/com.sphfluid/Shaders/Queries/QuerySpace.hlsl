#ifndef SPHFLUID_QUERY_SPACE
#define SPHFLUID_QUERY_SPACE

#define FLUID_PERIODIC // lengths of 0 switch it off
#include "../Solver/GridNeighbours.hlsl"

// A vector in the world and a number; mirrored by QueryWord.cs, 16 bytes. A query has one or more of them, the number of the first is its
// generation, 0 where it was removed.
struct QueryWord
{
    float3 Vector;
    uint Number;
};

uint _QueryCount;
uint _FirstResult; // of this kind in the results of all kinds

// Simulation space in the world.
float3 _DomainHalfSize;
float3 _PoseOrigin;
float3 _PoseX;
float3 _PoseY;
float3 _PoseZ;

float3 DirectionToSimulation(float3 world)
{
    return float3(dot(world, _PoseX), dot(world, _PoseY), dot(world, _PoseZ));
}

float3 PlaceToSimulation(float3 world)
{
    return DirectionToSimulation(world - _PoseOrigin);
}

float3 DirectionToWorld(float3 direction)
{
    return direction.x * _PoseX + direction.y * _PoseY + direction.z * _PoseZ;
}

#endif
