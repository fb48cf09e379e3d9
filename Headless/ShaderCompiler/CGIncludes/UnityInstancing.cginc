#ifndef UNITY_INSTANCING_INCLUDED
#define UNITY_INSTANCING_INCLUDED

#include "UnityShaderVariables.cginc"

#define UNITY_VERTEX_INPUT_INSTANCE_ID
#define UNITY_VERTEX_OUTPUT_STEREO
#define UNITY_SETUP_INSTANCE_ID(input)
#define UNITY_TRANSFER_INSTANCE_ID(input, output)
#define UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output)
#define UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input)
#define UNITY_INSTANCING_BUFFER_START(name) cbuffer UnityInstancing_##name {
#define UNITY_INSTANCING_BUFFER_END(name) };
#define UNITY_DEFINE_INSTANCED_PROP(type, name) type name;
#define UNITY_ACCESS_INSTANCED_PROP(buffer, name) name

#endif
