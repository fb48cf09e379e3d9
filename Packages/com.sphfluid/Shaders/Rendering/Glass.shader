// Panes of a tank, as in the samples: thin, clear, a little brighter where they are seen edge on. No light of the scene is asked for, so
// that they look alike in every pipeline.
Shader "SPH Fluid/Glass"
{
    Properties
    {
        [MainColor] _Color ("What it mirrors; alpha: cover seen straight on", Color) = (0.78, 0.9, 0.95, 0.03)
        _Edge ("Cover seen edge on", Range(0, 1)) = 0.45
    }

    SubShader
    {
        Tags { "RenderPipeline" = "HDRenderPipeline" "RenderType" = "Transparent" "Queue" = "Transparent" }

        Pass
        {
            Name "Forward"
            Cull Off
            ZWrite Off
            ZTest LEqual
            Blend One OneMinusSrcAlpha

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex PlacePane
            #pragma fragment ShadePane

            #define FLUID_HDRP 1
            #include "Glass.hlsl"
            ENDHLSL
        }
    }

    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "RenderType" = "Transparent" "Queue" = "Transparent" }

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
            #pragma vertex PlacePane
            #pragma fragment ShadePane

            #include "Glass.hlsl"
            ENDHLSL
        }
    }

    SubShader
    {
        Tags { "RenderType" = "Transparent" "Queue" = "Transparent" }

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
            #pragma vertex PlacePane
            #pragma fragment ShadePane

            #include "Glass.hlsl"
            ENDHLSL
        }
    }
}
