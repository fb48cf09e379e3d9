#ifndef UNITY_INSTANCING_INCLUDED
#define UNITY_INSTANCING_INCLUDED

#include "UnityShaderVariables.cginc"

#define UNITY_TRANSFER_INSTANCE_ID(input, output)
#if defined(STEREO_INSTANCING_ON)
#define UNITY_VERTEX_INPUT_INSTANCE_ID uint instanceID : SV_InstanceID;
#define UNITY_VERTEX_OUTPUT_STEREO uint stereoTargetEyeIndexAsRTArrayIdx : SV_RenderTargetArrayIndex;
#define UNITY_SETUP_INSTANCE_ID(input) unity_StereoEyeIndex = input.instanceID & 1u
#define UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output) output.stereoTargetEyeIndexAsRTArrayIdx = unity_StereoEyeIndex
#define UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input) unity_StereoEyeIndex = input.stereoTargetEyeIndexAsRTArrayIdx
#else
#define UNITY_VERTEX_INPUT_INSTANCE_ID
#define UNITY_VERTEX_OUTPUT_STEREO
#define UNITY_SETUP_INSTANCE_ID(input)
#define UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output)
#define UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input)
#endif
#define UNITY_INSTANCING_BUFFER_START(name) cbuffer UnityInstancing_##name {
#define UNITY_INSTANCING_BUFFER_END(name) };
#define UNITY_DEFINE_INSTANCED_PROP(type, name) type name;
#define UNITY_ACCESS_INSTANCED_PROP(buffer, name) name

#endif
