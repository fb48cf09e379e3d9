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
            #pragma multi_compile _ STEREO_INSTANCING_ON
            #pragma vertex Cover
            #pragma fragment Copy

            #if defined(STEREO_INSTANCING_ON)
            Texture2DArray<float> _CameraDepthAttachment;
            #define EYE_FIELD uint eye : SV_RenderTargetArrayIndex;
            #define EYE_TO(output, instance) output.eye = instance & 1u;
            #define PLACE(uv) float3(uv, (float)input.eye)
            #else
            Texture2D<float> _CameraDepthAttachment;
            #define EYE_FIELD
            #define EYE_TO(output, instance)
            #define PLACE(uv) uv
            #endif
            SamplerState sampler_PointClamp;

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

            float4 Copy(Varyings input) : SV_Target
            {
                return _CameraDepthAttachment.SampleLevel(sampler_PointClamp, PLACE(input.uv), 0.0);
            }
            ENDHLSL
        }
    }
}
