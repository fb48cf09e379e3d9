// Water as a camera in it sees it, after the water that others see. FLUID_HDRP: see FluidShading.hlsl.
Shader "Hidden/SPH Fluid/Water From Within"
{
    SubShader
    {
        Tags { "RenderType" = "Transparent" "Queue" = "Transparent+1" }

        // No LightMode: drawn by the Built-in pipeline in forward and deferred rendering, by URP and HDRP as SRPDefaultUnlit.
        Pass
        {
            Name "Forward"
            Cull Front
            ZWrite Off
            ZTest Always
            Blend One OneMinusSrcAlpha

            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma multi_compile_local _ FLUID_HDRP
            #pragma vertex FetchSurface
            #pragma fragment ShadeFromWithin

            #include "WaterFromWithin.hlsl"
            ENDHLSL
        }
    }
}
