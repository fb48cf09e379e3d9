// Clear water. Drawn with an index buffer over the vertices of the sparse surface. FLUID_HDRP: see FluidShading.hlsl.
Shader "SPH Fluid/Water"
{
    Properties
    {
        _Refraction ("Refraction, 1: as much as in nature", Range(0, 1)) = 1
        _Smoothness ("Smoothness", Range(0, 1)) = 0.9
        _ShadowStrength ("Strength of the shadow", Range(0, 1)) = 0.25
    }

    SubShader
    {
        Tags { "RenderType" = "Transparent" "Queue" = "Transparent" }

        // No LightMode: drawn by the Built-in pipeline in forward and deferred rendering, by URP and HDRP as SRPDefaultUnlit.
        Pass
        {
            Name "Forward"
            Cull Back
            ZWrite On
            ZTest LEqual
            Blend One OneMinusSrcAlpha

            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma multi_compile_local _ FLUID_HDRP
            #pragma vertex FetchSurface
            #pragma fragment ShadeWater

            #include "WaterShading.hlsl"
            ENDHLSL
        }

        // Built-in and URP.
        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            Cull Back
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex FetchSurface
            #pragma fragment CastWaterShadow

            #define FLUID_SHADOW_CASTER 1
            #include "WaterShading.hlsl"
            ENDHLSL
        }
    }
}
