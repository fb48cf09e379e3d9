// How much water lies behind each pixel: the closed surface's faces added up, the far ones with plus, the near ones with minus.
// FLUID_HDRP: see FluidShading.hlsl.
Shader "Hidden/SPH Fluid/Water Thickness"
{
    SubShader
    {
        Pass
        {
            Name "Thickness"
            Cull Off
            ZWrite Off
            ZTest Always
            Blend One One
            BlendOp Add, Max

            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile_local _ FLUID_HDRP
            #pragma vertex FetchDepth
            #pragma fragment AddDepth

            #include "WaterThickness.hlsl"
            ENDHLSL
        }
    }
}
