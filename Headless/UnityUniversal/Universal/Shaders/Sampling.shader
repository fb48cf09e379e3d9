// The mean of four bilinear samples, two texels away from the middle.
Shader "Hidden/Universal Render Pipeline/Sampling"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        ZWrite Off
        ZTest Always
        Cull Off

        Pass
        {
            Name "BoxDownsample"
            HLSLPROGRAM
            #pragma target 4.5
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma vertex Cover
            #pragma fragment Mean

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
            SamplerState sampler_LinearClamp;
            float _SampleOffset;

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
                output.uv = float2(corner.x, 1.0 - corner.y);
                return output;
            }

            float4 Mean(Varyings input) : SV_Target
            {
                float2 size = 0.0;
                #if defined(STEREO_INSTANCING_ON)
                float slices = 0.0;
                _BlitTexture.GetDimensions(size.x, size.y, slices);
                #else
                _BlitTexture.GetDimensions(size.x, size.y);
                #endif
                float2 reach = _SampleOffset / size;
                float4 sum = _BlitTexture.SampleLevel(sampler_LinearClamp, PLACE(input.uv + float2(-1.0, -1.0) * reach), 0.0);
                sum += _BlitTexture.SampleLevel(sampler_LinearClamp, PLACE(input.uv + float2(1.0, -1.0) * reach), 0.0);
                sum += _BlitTexture.SampleLevel(sampler_LinearClamp, PLACE(input.uv + float2(-1.0, 1.0) * reach), 0.0);
                sum += _BlitTexture.SampleLevel(sampler_LinearClamp, PLACE(input.uv + float2(1.0, 1.0) * reach), 0.0);
                return 0.25 * sum;
            }
            ENDHLSL
        }
    }
}
