#ifndef UNITY_LIGHTING_COMMON_INCLUDED
#define UNITY_LIGHTING_COMMON_INCLUDED

float4 _LightColor0;
float4 _SpecColor;

#endif
