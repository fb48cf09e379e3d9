// Solid things around a liquid, as in the samples: one colour, or tiles of two, lit by the main light, further lights and the ambient
// light. Looks alike in the Built-in pipeline and in URP; in HDRP, whose lights have no interface for shaders of others, it is shaded
// from above by a light of its own.
Shader "SPH Fluid/Scenery"
{
    Properties
    {
        [MainColor] _Color ("Colour", Color) = (0.8, 0.8, 0.8, 1)
        _Smoothness ("Smoothness", Range(0, 1)) = 0.3
        _TileColor ("Colour of every other tile", Color) = (0.7, 0.7, 0.7, 1)
        _TileSize ("Edge of a tile [m], 0: no tiles", Float) = 0
        _GroutColor ("Colour between tiles", Color) = (0.6, 0.6, 0.6, 1)
        _Grout ("Width of the grout [m]", Float) = 0
        _FadeColor ("Colour that it fades to far away", Color) = (0.84, 0.91, 0.97, 1)
        _FadeDistance ("Distance at which it fades [m], 0: never", Float) = 0
    }

    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "RenderType" = "Opaque" "Queue" = "Geometry" }

        // Forward, forward+ and deferred rendering.
        Pass
        {
            Name "Forward"
            Tags { "LightMode" = "UniversalForwardOnly" }

            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma multi_compile _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_CASCADE _MAIN_LIGHT_SHADOWS_SCREEN
            #pragma multi_compile _ _ADDITIONAL_LIGHTS_VERTEX _ADDITIONAL_LIGHTS
            #pragma multi_compile_fragment _ _ADDITIONAL_LIGHT_SHADOWS
            #pragma multi_compile _ _CLUSTER_LIGHT_LOOP _FORWARD_PLUS
            #pragma vertex PlaceScenery
            #pragma fragment ShadeScenery

            #include "SceneryUniversal.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            ColorMask 0

            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile_vertex _ _CASTING_PUNCTUAL_LIGHT_SHADOW
            #pragma vertex PlaceSceneryShadow
            #pragma fragment ShowNothing

            #include "SceneryUniversal.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "DepthOnly"
            Tags { "LightMode" = "DepthOnly" }
            ColorMask R

            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma vertex PlaceScenery
            #pragma fragment ShowSceneryDepth

            #include "SceneryUniversal.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "DepthNormalsOnly"
            Tags { "LightMode" = "DepthNormalsOnly" }

            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma vertex PlaceScenery
            #pragma fragment ShowSceneryNormal

            #include "SceneryUniversal.hlsl"
            ENDHLSL
        }
    }

    SubShader
    {
        Tags { "RenderPipeline" = "HDRenderPipeline" "RenderType" = "Opaque" "Queue" = "Geometry" }

        Pass
        {
            Name "ForwardOnly"
            Tags { "LightMode" = "ForwardOnly" }

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex PlaceScenery
            #pragma fragment ShadeScenery

            #include "SceneryHighDefinition.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "DepthForwardOnly"
            Tags { "LightMode" = "DepthForwardOnly" }
            ColorMask 0

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex PlaceScenery
            #pragma fragment ShowNothing

            #include "SceneryHighDefinition.hlsl"
            ENDHLSL
        }
    }

    // Built-in, forward and deferred rendering.
    SubShader
    {
        Tags { "RenderType" = "Opaque" "Queue" = "Geometry" }

        Pass
        {
            Name "Forward"
            Tags { "LightMode" = "ForwardBase" }

            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma multi_compile_fwdbase nolightmap nodirlightmap nodynlightmap
            #pragma vertex PlaceScenery
            #pragma fragment ShadeScenery

            #include "SceneryBuiltIn.hlsl"
            ENDHLSL
        }

        // Drawn once more for each further light of a pixel: directional, point and spot lights.
        Pass
        {
            Name "ForwardAdd"
            Tags { "LightMode" = "ForwardAdd" }
            Blend One One
            ZWrite Off
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma multi_compile_fwdadd
            #pragma vertex PlaceScenery
            #pragma fragment AddLight

            #include "SceneryBuiltIn.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }

            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma multi_compile_shadowcaster
            #pragma vertex PlaceSceneryShadow
            #pragma fragment CastSceneryShadow

            #include "SceneryBuiltIn.hlsl"
            ENDHLSL
        }
    }
}
