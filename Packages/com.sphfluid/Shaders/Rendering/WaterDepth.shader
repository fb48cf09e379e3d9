// The nearest water's depth before the water itself, where it is blended over the scene: else its layers would be blended in the order of
// their triangles. FLUID_HDRP: see FluidShading.hlsl.
Shader "Hidden/SPH Fluid/Water Depth"
{
    SubShader
    {
        Tags { "RenderType" = "Transparent" "Queue" = "Transparent-1" }

        Pass
        {
            Name "Depth"
            Cull Back
            ZWrite On
            ZTest LEqual
            ColorMask 0

            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma multi_compile_local _ FLUID_HDRP
            #pragma vertex FetchSurface
            #pragma fragment ShowNothing

            #include "SurfaceDrawing.hlsl"

            float4 ShowNothing(SurfaceFragment input) : SV_Target
            {
                return 0.0;
            }
            ENDHLSL
        }
    }
}
