// Light that waves gather on what stands in the water: two pictures of the surface from the light, then the scene that they shine on.
Shader "Hidden/SPH Fluid/Caustics"
{
    SubShader
    {
        Pass
        {
            Name "Ends"
            Cull Front
            ZWrite Off
            ZTest Always
            Blend One One
            BlendOp Max

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex FetchSurface
            #pragma fragment ShowEnd

            #include "CausticsMap.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "Map"
            Cull Back
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex FetchSurface
            #pragma fragment ShowRefraction

            #include "CausticsMap.hlsl"
            ENDHLSL
        }

        // Twice what is drawn times what is there: a picture without values above 1 can be made twice as bright.
        Pass
        {
            Name "Light"
            Cull Front
            ZWrite Off
            ZTest Always
            Blend DstColor SrcColor
            ColorMask RGB

            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma vertex CoverDomain
            #pragma fragment GatherLight

            #include "CausticsLight.hlsl"
            ENDHLSL
        }
    }
}
