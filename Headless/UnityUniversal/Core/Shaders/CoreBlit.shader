// Copies a texture over the whole target: by a triangle in clip space, so that the first row of the source lies in the first row of the target.
Shader "Hidden/Universal/CoreBlit"
{
    HLSLINCLUDE
    #pragma target 4.5
    #pragma multi_compile _ STEREO_INSTANCING_ON

    #if defined(STEREO_INSTANCING_ON)
    Texture2DArray<float4> _BlitTexture;
    #define EYE_FIELD uint eye : SV_RenderTargetArrayIndex;
    #define EYE_TO(output, instance) output.eye = instance & 1u;
    #define PLACE(uv) float3(uv, (float)input.eye)
    #else
    Texture2D<float4> _BlitTexture;
    #define EYE_FIELD
    #define EYE_TO(output, instance)
    #define PLACE(uv) uv
    #endif
    SamplerState sampler_PointClamp;
    SamplerState sampler_LinearClamp;
    float4 _BlitScaleBias;
    float _BlitMipLevel;

    struct Varyings
    {
        float4 position : SV_Position;
        float2 uv : TEXCOORD0;
        EYE_FIELD
    };

    Varyings Cover(uint index : SV_VertexID, uint instance : SV_InstanceID)
    {
        float2 corner = float2((index << 1) & 2, index & 2);
        Varyings output;
        EYE_TO(output, instance)
        output.position = float4(corner * 2.0 - 1.0, 1.0, 1.0);
        output.uv = float2(corner.x, 1.0 - corner.y) * _BlitScaleBias.xy + _BlitScaleBias.zw;
        return output;
    }

    float4 CopyNearest(Varyings input) : SV_Target
    {
        return _BlitTexture.SampleLevel(sampler_PointClamp, PLACE(input.uv), _BlitMipLevel);
    }

    float4 CopyBilinear(Varyings input) : SV_Target
    {
        return _BlitTexture.SampleLevel(sampler_LinearClamp, PLACE(input.uv), _BlitMipLevel);
    }
    ENDHLSL

    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        ZWrite Off
        ZTest Always
        Blend Off
        Cull Off

        Pass
        {
            Name "Nearest"
            HLSLPROGRAM
            #pragma vertex Cover
            #pragma fragment CopyNearest
            ENDHLSL
        }

        Pass
        {
            Name "Bilinear"
            HLSLPROGRAM
            #pragma vertex Cover
            #pragma fragment CopyBilinear
            ENDHLSL
        }
    }
}
