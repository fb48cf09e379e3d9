// The variables of Unity's buffer UnityShadows, a pixel each.
#ifndef SPHFLUID_SHADOW_CONSTANTS_INCLUDED
#define SPHFLUID_SHADOW_CONSTANTS_INCLUDED

#include "UnityShaderVariables.cginc"

float4 CoverPixels(uint id : SV_VertexID) : SV_Position
{
    return float4(id == 1u ? 3.0 : -1.0, id == 2u ? 3.0 : -1.0, 0.5, 1.0);
}

float4 CopyConstant(float4 pixel : SV_Position) : SV_Target
{
    uint i = (uint)pixel.x;
    float4 copied = unity_ShadowFadeCenterAndType;
    if (i < 16u)
        copied = unity_WorldToShadow[i / 4u][i % 4u];
    else if (i < 20u)
        copied = float4(unity_ShadowSplitSpheres[i - 16u].xyz, unity_ShadowSplitSqRadii[i - 16u]);
    else if (i == 20u)
        copied = _LightSplitsNear;
    else if (i == 21u)
        copied = _LightSplitsFar;
    else if (i == 22u)
        copied = _LightShadowData;
    return copied;
}

#endif
