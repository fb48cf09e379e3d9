// Particles as textured, lit squares that face the camera. Drawn with MeshTopology.Triangles, six vertices a particle.
// FLUID_HDRP: see FluidShading.hlsl.
Shader "SPH Fluid/Particles"
{
    Properties
    {
        _MainTex ("Sprite: colour, cut out by alpha", 2D) = "white" {}
        _Color ("Colour at rest", Color) = (0.12, 0.42, 0.72, 1)
        _FastColor ("Colour at speed", Color) = (0.85, 0.95, 1, 1)
        _Smoothness ("Smoothness", Range(0, 1)) = 0.5
    }

    SubShader
    {
        Tags { "RenderType" = "TransparentCutout" "Queue" = "AlphaTest" }

        // No LightMode: drawn by the Built-in pipeline in forward and deferred rendering, by URP and HDRP as SRPDefaultUnlit.
        Pass
        {
            Name "Forward"
            Cull Off
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma multi_compile_local _ FLUID_HDRP
            #pragma vertex ExpandSquare
            #pragma fragment ShadeSquare

            #include "ParticleSquares.hlsl"
            ENDHLSL
        }

        // Built-in and URP.
        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            Cull Off
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma vertex ExpandSquare
            #pragma fragment CastSquareShadow

            #define FLUID_SHADOW_CASTER 1
            #include "ParticleSquares.hlsl"
            ENDHLSL
        }

        // URP's depth priming and depth texture, HDRP's depth prepass.
        Pass
        {
            Name "DepthOnly"
            Tags { "LightMode" = "DepthOnly" }
            Cull Off
            ZWrite On
            ZTest LEqual
            ColorMask R

            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma multi_compile_local _ FLUID_HDRP
            #pragma vertex ExpandSquare
            #pragma fragment ShowSquareDepth

            #include "ParticleSquares.hlsl"
            ENDHLSL
        }

        // URP, where an effect wants normals.
        Pass
        {
            Name "DepthNormalsOnly"
            Tags { "LightMode" = "DepthNormalsOnly" }
            Cull Off
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma vertex ExpandSquare
            #pragma fragment ShowSquareNormal

            #include "ParticleSquares.hlsl"
            ENDHLSL
        }
    }
}
