// Drops of particles that left the surface. FLUID_HDRP: see FluidShading.hlsl.
Shader "Hidden/SPH Fluid/Spray"
{
    SubShader
    {
        Tags { "RenderType" = "Transparent" "Queue" = "Transparent+2" }

        // No LightMode: drawn by the Built-in pipeline in forward and deferred rendering, by URP and HDRP as SRPDefaultUnlit.
        Pass
        {
            Name "Forward"
            Cull Off
            ZWrite Off
            ZTest LEqual
            Blend One OneMinusSrcAlpha

            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma multi_compile_local _ FLUID_HDRP
            #pragma vertex ExpandDrop
            #pragma fragment ShadeDropBeforeWater

            #include "SprayDrops.hlsl"
            ENDHLSL
        }
    }
}
