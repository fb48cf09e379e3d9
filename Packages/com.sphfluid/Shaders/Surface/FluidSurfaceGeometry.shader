// The thesis's surface: marching cubes in a geometry shader, lit per pixel. Drawn with MeshTopology.Points, one point a cube.
// FLUID_CUBES draws the cubes that the surface cuts instead of the triangles in them.
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

        Pass
        {
            Name "ForwardBase"
            Tags { "LightMode" = "ForwardBase" }
            Cull Back
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 4.5
            #pragma require geometry
            #pragma multi_compile_local _ FLUID_CUBES
            #pragma vertex PassThrough
            #pragma geometry GenerateIsosurface
            #pragma fragment ShadeSurface

            #include "SurfaceGeometry.hlsl"
            #include "SurfaceShading.hlsl"
            ENDHLSL
        }

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
            #pragma fragment CastShadow

            #define FLUID_SHADOW_CASTER 1
            #include "SurfaceGeometry.hlsl"

            float4 CastShadow(SurfaceFragment input) : SV_Target
            {
                return 0.0;
            }
            ENDHLSL
        }
    }
}
