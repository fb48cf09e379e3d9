// Built-in: draws what places shadows on the map into 24 pixels, while Unity has it set for the main light. Read by ReceivedShadow.hlsl.
Shader "Hidden/SPH Fluid/Shadow Constants"
{
    SubShader
    {
        Pass
        {
            Name "Copy"
            Cull Off
            ZWrite Off
            ZTest Always

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex CoverPixels
            #pragma fragment CopyConstant

            #include "ShadowConstants.hlsl"
            ENDHLSL
        }
    }
}
