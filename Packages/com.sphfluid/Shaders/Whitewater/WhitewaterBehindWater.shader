// Whitewater in the picture of the scene that water refracts: bubbles, and what a sheet of water in front would hide.
Shader "Hidden/SPH Fluid/Whitewater Behind Water"
{
    SubShader
    {
        Pass
        {
            Name "Copy"
            Cull Off
            ZWrite Off
            ZTest Always
            Blend One OneMinusSrcAlpha

            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma vertex ExpandSpotBehindWater
            #pragma fragment ShadeSpot

            #include "WhitewaterDrawing.hlsl"
            ENDHLSL
        }
    }
}
