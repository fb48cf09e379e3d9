// Particles as textured, lit squares that face the camera. Drawn with MeshTopology.Triangles, six vertices a particle.
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

        Pass
        {
            Name "ForwardBase"
            Tags { "LightMode" = "ForwardBase" }
            Cull Off
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex ExpandSquare
            #pragma fragment ShadeSquare

            #include "ParticleSquares.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            Cull Off
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex ExpandSquare
            #pragma fragment CastSquareShadow

            #define FLUID_SHADOW_CASTER 1
            #include "ParticleSquares.hlsl"
            ENDHLSL
        }
    }
}
