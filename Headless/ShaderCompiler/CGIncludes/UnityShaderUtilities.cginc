#ifndef UNITY_SHADER_UTILITIES_INCLUDED
#define UNITY_SHADER_UTILITIES_INCLUDED

#include "UnityShaderVariables.cginc"

float4 UnityObjectToClipPos(float3 position)
{
    return mul(unity_MatrixVP, mul(unity_ObjectToWorld, float4(position, 1.0)));
}

float4 UnityObjectToClipPos(float4 position)
{
    return UnityObjectToClipPos(position.xyz);
}

#endif
