// The thesis's surface: marching cubes in a geometry shader, lit per pixel. Drawn with MeshTopology.Points, one point a
// cube. FLUID_CUBES draws the edges of the cubes with a vertex inside instead of the triangles in them. FLUID_HDRP: see
// FluidShading.hlsl.
Shader "SPH Fluid/Surface (Geometry Shader)"
{
    Properties
    {
        _Color ("Colour of the liquid", Color) = (0.06, 0.4, 0.66, 1)
        _Smoothness ("Smoothness", Range(0, 1)) = 0.75
    }

    SubShader
    {
        Tags { "RenderType" = "Opaque" "Queue" = "Geometry" }

        // No LightMode: drawn by the Built-in pipeline in forward and deferred rendering, by URP and HDRP as
        // SRPDefaultUnlit.
        Pass
        {
            Name "Forward"
            Cull Back
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 4.5
            #pragma require geometry
            #pragma multi_compile_local _ FLUID_CUBES
            #pragma multi_compile_local _ FLUID_HDRP
            #pragma vertex PassThrough
            #pragma geometry GenerateIsosurface
            #pragma fragment ShadeSurface

            #include "SurfaceGeometry.hlsl"
            #include "Packages/com.sphfluid/Shaders/Surface/SurfaceShading.hlsl"
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
            #pragma require geometry
            #pragma multi_compile_local _ FLUID_CUBES
            #pragma vertex PassThrough
            #pragma geometry GenerateIsosurface
            #pragma fragment CastSurfaceShadow

            #define FLUID_SHADOW_CASTER 1
            #include "SurfaceGeometry.hlsl"
            #include "Packages/com.sphfluid/Shaders/Surface/SurfaceShading.hlsl"
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
            #pragma require geometry
            #pragma multi_compile_local _ FLUID_CUBES
            #pragma multi_compile_local _ FLUID_HDRP
            #pragma vertex PassThrough
            #pragma geometry GenerateIsosurface
            #pragma fragment ShowSurfaceDepth

            #include "SurfaceGeometry.hlsl"
            #include "Packages/com.sphfluid/Shaders/Surface/SurfaceShading.hlsl"
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
            #pragma require geometry
            #pragma multi_compile_local _ FLUID_CUBES
            #pragma vertex PassThrough
            #pragma geometry GenerateIsosurface
            #pragma fragment ShowSurfaceNormal

            #include "SurfaceGeometry.hlsl"
            #include "Packages/com.sphfluid/Shaders/Surface/SurfaceShading.hlsl"
            ENDHLSL
        }
    }
}
