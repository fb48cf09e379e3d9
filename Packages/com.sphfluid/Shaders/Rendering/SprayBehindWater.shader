// Drops in the picture of the scene that water refracts: else a sheet of water in front would hide them.
Shader "Hidden/SPH Fluid/Spray Behind Water"
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
            #pragma vertex ExpandDropBehindWater
            #pragma fragment ShadeDropBehindWater

            #include "SprayDrops.hlsl"
            ENDHLSL
        }
    }
}
