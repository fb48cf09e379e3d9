// Stand-in for URP's Unlit.
Shader "Universal Render Pipeline/Unlit"
{
    Properties
    {
        [MainTexture] _BaseMap ("Texture", 2D) = "white" {}
        [MainColor] _BaseColor ("Color", Color) = (1, 1, 1, 1)
        _Cutoff ("Alpha Cutoff", Range(0, 1)) = 0.5
        _Cull ("Cull", Float) = 2
        _SrcBlend ("Source Blend", Float) = 1
        _DstBlend ("Destination Blend", Float) = 0
        _ZWrite ("Z Write", Float) = 1
    }

    HLSLINCLUDE
    #pragma target 4.5

    float4x4 unity_ObjectToWorld;
    float4x4 unity_MatrixVP;
    Texture2D<float4> _BaseMap;
    SamplerState sampler_BaseMap;
    float4 _BaseMap_ST;
    float4 _BaseColor;
    float _Cutoff;

    struct Varyings
    {
        float4 clip : SV_Position;
        float2 uv : TEXCOORD0;
    };

    Varyings Place(float3 position : POSITION, float2 uv : TEXCOORD0)
    {
        Varyings output;
        output.clip = mul(unity_MatrixVP, mul(unity_ObjectToWorld, float4(position, 1.0)));
        output.uv = uv * _BaseMap_ST.xy + _BaseMap_ST.zw;
        return output;
    }

    float4 Colour(Varyings input)
    {
        float4 colour = _BaseMap.Sample(sampler_BaseMap, input.uv) * _BaseColor;
    #if defined(_ALPHATEST_ON)
        clip(colour.a - _Cutoff);
    #endif
        return colour;
    }
    ENDHLSL

    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "RenderType" = "Opaque" }

        Pass
        {
            Name "Unlit"
            Tags { "LightMode" = "UniversalForwardOnly" }
            Blend [_SrcBlend] [_DstBlend]
            ZWrite [_ZWrite]
            Cull [_Cull]

            HLSLPROGRAM
            #pragma vertex Place
            #pragma fragment Show
            #pragma shader_feature_local _ALPHATEST_ON

            float4 Show(Varyings input) : SV_Target
            {
                return Colour(input);
            }
            ENDHLSL
        }

        Pass
        {
            Name "DepthOnly"
            Tags { "LightMode" = "DepthOnly" }
            ColorMask R
            Cull [_Cull]

            HLSLPROGRAM
            #pragma vertex Place
            #pragma fragment Depth
            #pragma shader_feature_local _ALPHATEST_ON

            float4 Depth(Varyings input) : SV_Target
            {
                Colour(input);
                return input.clip.z;
            }
            ENDHLSL
        }
    }
}
