// Drawn with additive blending over the closed surface, alpha with the larger of two. Depths count from a reference point in the middle of
// the liquid, so that half floats are precise where the liquid is. Red: sum of far depths minus sum of near depths; green: number of far
// faces minus number of near ones. Worked example, reference 2 m from the camera: a layer from 1.9 m to 2.2 m gives red 0.2 + 0.1 = 0.3,
// green 0. A camera within the liquid sees only its far face at 2.2 m: red 0.2, green 1, together 0.2 + 1 * 2 = 2.2 m. Alpha: minus the
// depth of the nearest far face, where the first layer ends; with another layer from 2.5 m to 2.6 m it is -0.2 still. Blue: number of near
// faces, 1 and then 2.
#ifndef SPHFLUID_WATER_THICKNESS_INCLUDED
#define SPHFLUID_WATER_THICKNESS_INCLUDED

#include "SurfaceDrawing.hlsl"

#define NO_FAR_FACE -1000.0 // ThicknessPass.cs clears to it

struct DepthFragment
{
    float4 clipPosition : SV_Position;
    float depth : TEXCOORD0; // [m] along the camera's axis, from the reference point
};

DepthFragment FetchDepth(uint vertexId : SV_VertexID)
{
    SurfaceFragment surface = FetchSurface(vertexId);
    DepthFragment output;
    output.clipPosition = surface.clipPosition;
    output.depth = -dot(unity_MatrixV[2].xyz, FluidWorldDirection(surface.local));
    return output;
}

float4 AddDepth(DepthFragment input, bool near : SV_IsFrontFace) : SV_Target
{
    float side = near ? -1.0 : 1.0;
    return float4(side * input.depth, side, near ? 1.0 : 0.0, near ? NO_FAR_FACE : -input.depth);
}

#endif
