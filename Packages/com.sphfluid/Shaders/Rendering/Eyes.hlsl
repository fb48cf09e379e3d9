// The camera's matrices, of the eye that is drawn where Unity draws both at once (single-pass instanced): each into a slice of an array, by
// the number of the instance. Unity doubles the instances of ordinary draws, but not of those whose arguments lie in a buffer: these are
// issued once more for the right eye, with _FluidEye 1 (EyeDraws.cs).
#ifndef SPHFLUID_EYES_INCLUDED
#define SPHFLUID_EYES_INCLUDED

#if defined(STEREO_INSTANCING_ON)

// Laid out as Unity's UnityShaderVariables.cginc has it; scriptable pipelines set the arrays by their names.
cbuffer UnityStereoGlobals
{
    float4x4 unity_StereoMatrixP[2];
    float4x4 unity_StereoMatrixV[2];
    float4x4 unity_StereoMatrixInvV[2];
    float4x4 unity_StereoMatrixVP[2];
    float4x4 unity_StereoCameraProjection[2];
    float4x4 unity_StereoCameraInvProjection[2];
    float4x4 unity_StereoWorldToCamera[2];
    float4x4 unity_StereoCameraToWorld[2];
    float3 unity_StereoWorldSpaceCameraPos[2];
    float4 unity_StereoScaleOffset[2];
};

float _FluidEye; // 1 where a draw is the right eye's alone
static uint fluidEye;

#define unity_MatrixV unity_StereoMatrixV[fluidEye]
#define unity_MatrixVP unity_StereoMatrixVP[fluidEye]
#define _WorldSpaceCameraPos unity_StereoWorldSpaceCameraPos[fluidEye]

// In a vertex stage: the last parameter, the first statement and what fills the output. In a struct: the last field. In a pixel stage: the
// first statement.
#define EYE_PARAMETER , uint instance : SV_InstanceID
#define EYE_OF_INSTANCE fluidEye = (instance + (uint)_FluidEye) & 1u;
#define EYE_TO(output) output.eye = fluidEye;
#define EYE_FIELD uint eye : SV_RenderTargetArrayIndex;
#define EYE_OF(input) fluidEye = input.eye;

#define EYE_TEXTURE Texture2DArray

float3 EyePlace(float2 place)
{
    return float3(place, (float)fluidEye);
}

#define EYE_TEXTURE_SIZE(image, size) { float slices = 0.0; image.GetDimensions(size.x, size.y, slices); }

#else

float4x4 unity_MatrixV;
float4x4 unity_MatrixVP;
float3 _WorldSpaceCameraPos; // absolute in every pipeline

#define EYE_PARAMETER
#define EYE_OF_INSTANCE
#define EYE_TO(output)
#define EYE_FIELD
#define EYE_OF(input)

#define EYE_TEXTURE Texture2D

float2 EyePlace(float2 place)
{
    return place;
}

#define EYE_TEXTURE_SIZE(image, size) image.GetDimensions(size.x, size.y);

#endif

#endif
