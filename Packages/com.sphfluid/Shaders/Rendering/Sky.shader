// A clear sky with a sun and soft clouds, for the Lighting window's Skybox Material: something worth mirroring for water. Drawn by the
// Built-in pipeline and by URP, which hand over the scene's sun as they do to Unity's own skyboxes; HDRP has skies of its own and draws no
// skybox material.
Shader "SPH Fluid/Sky"
{
    Properties
    {
        _Zenith ("Colour overhead", Color) = (0.2, 0.45, 0.82, 1)
        _Horizon ("Colour at the horizon", Color) = (0.84, 0.91, 0.97, 1)
        _Ground ("Colour below the horizon", Color) = (0.72, 0.72, 0.7, 1)
        _Sun ("Colour of the sun", Color) = (1, 0.95, 0.84, 1)
        _SunRadius ("Radius of the sun [degrees]", Range(0, 5)) = 0.9
        _SunLight ("Brightness of the sun's disc", Range(0, 10)) = 4
        _Glow ("Brightness of the glow around the sun", Range(0, 2)) = 0.5
        _Cloud ("Colour of clouds", Color) = (1, 1, 1, 1)
        _CloudShade ("Colour of clouds away from the sun", Color) = (0.72, 0.78, 0.86, 1)
        _CloudCover ("Share of the sky under clouds", Range(0, 1)) = 0.45
        _CloudScale ("Clouds across the sky", Range(0.2, 4)) = 1
    }

    SubShader
    {
        Tags { "Queue" = "Background" "RenderType" = "Background" "PreviewType" = "Skybox" }

        Pass
        {
            Name "Sky"
            Cull Off
            ZWrite Off

            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma vertex PlaceSky
            #pragma fragment ShadeSky

            #include "Sky.hlsl"
            ENDHLSL
        }
    }
}
