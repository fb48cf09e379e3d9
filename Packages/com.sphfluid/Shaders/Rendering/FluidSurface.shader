// The liquid's surface, opaque, for weak devices and stylised pictures. Drawn with an index buffer over the vertices of the sparse surface.
// FLUID_HDRP: see FluidShading.hlsl.
Shader "SPH Fluid/Surface"
{
    Properties
    {
        _Color ("Colour of the liquid", Color) = (0.06, 0.4, 0.66, 1)
        _Smoothness ("Smoothness", Range(0, 1)) = 0.75
    }

    SubShader
    {
        Tags { "RenderType" = "Opaque" "Queue" = "Geometry" }

        // No LightMode: drawn by the Built-in pipeline in forward and deferred rendering, by URP and HDRP as SRPDefaultUnlit.
        Pass
        {
            Name "Forward"
            Cull Back
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma multi_compile_local _ FLUID_HDRP
            #pragma vertex FetchSurface
            #pragma fragment ShadeSurface

            #include "SurfaceDrawing.hlsl"
            #include "../Surface/SurfaceShading.hlsl"
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
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma vertex FetchSurface
            #pragma fragment CastSurfaceShadow

            #define FLUID_SHADOW_CASTER 1
            #include "SurfaceDrawing.hlsl"
            #include "../Surface/SurfaceShading.hlsl"
            ENDHLSL
        }

        // URP's depth priming and depth texture, HDRP's depth prepass.
        Pass
        {
            Name "DepthOnly"
            Tags { "LightMode" = "DepthOnly" }
            Cull Back
            ZWrite On
            ZTest LEqual
            ColorMask R

            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma multi_compile_local _ FLUID_HDRP
            #pragma vertex FetchSurface
            #pragma fragment ShowSurfaceDepth

            #include "SurfaceDrawing.hlsl"
            #include "../Surface/SurfaceShading.hlsl"
            ENDHLSL
        }

        // URP, where an effect wants normals.
        Pass
        {
            Name "DepthNormalsOnly"
            Tags { "LightMode" = "DepthNormalsOnly" }
            Cull Back
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma vertex FetchSurface
            #pragma fragment ShowSurfaceNormal

            #include "SurfaceDrawing.hlsl"
            #include "../Surface/SurfaceShading.hlsl"
            ENDHLSL
        }
    }
}
