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
            #pragma vertex Cover
            #pragma fragment Mean

            Texture2D<float4> _BlitTexture;
            SamplerState sampler_LinearClamp;
            float _SampleOffset;

            struct Varyings
            {
                float4 position : SV_Position;
                float2 uv : TEXCOORD0;
            };

            Varyings Cover(uint index : SV_VertexID)
            {
                float2 corner = float2((index << 1) & 2, index & 2);
                Varyings output;
                output.position = float4(corner * 2.0 - 1.0, 1.0, 1.0);
                output.uv = float2(corner.x, 1.0 - corner.y);
                return output;
            }

            float4 Mean(Varyings input) : SV_Target
            {
                float2 size = 0.0;
                _BlitTexture.GetDimensions(size.x, size.y);
                float2 reach = _SampleOffset / size;
                float4 sum = _BlitTexture.SampleLevel(sampler_LinearClamp, input.uv + float2(-1.0, -1.0) * reach, 0.0);
                sum += _BlitTexture.SampleLevel(sampler_LinearClamp, input.uv + float2(1.0, -1.0) * reach, 0.0);
                sum += _BlitTexture.SampleLevel(sampler_LinearClamp, input.uv + float2(-1.0, 1.0) * reach, 0.0);
                sum += _BlitTexture.SampleLevel(sampler_LinearClamp, input.uv + float2(1.0, 1.0) * reach, 0.0);
                return 0.25 * sum;
            }
            ENDHLSL
        }
    }
}
