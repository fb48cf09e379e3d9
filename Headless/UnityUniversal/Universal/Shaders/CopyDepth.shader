// The camera's depth as a colour.
Shader "Hidden/Universal Render Pipeline/CopyDepth"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        ZWrite Off
        ZTest Always
        Cull Off

        Pass
        {
            Name "CopyDepth"
            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex Cover
            #pragma fragment Copy

            Texture2D<float> _CameraDepthAttachment;
            SamplerState sampler_PointClamp;

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

            float4 Copy(Varyings input) : SV_Target
            {
                return _CameraDepthAttachment.SampleLevel(sampler_PointClamp, input.uv, 0.0);
            }
            ENDHLSL
        }
    }
}
