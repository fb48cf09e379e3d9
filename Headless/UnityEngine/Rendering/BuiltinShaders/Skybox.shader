// A plain gradient behind everything, drawn as one triangle at the far plane.
Shader "Skybox/Procedural"
{
    SubShader
    {
        Tags { "Queue" = "Background" "RenderType" = "Background" "PreviewType" = "Skybox" }

        Pass
        {
            ZWrite Off
            ZTest LEqual
            Cull Off

            HLSLPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment
            #include "UnityCG.cginc"

            float4 _SkyZenith;
            float4 _SkyHorizon;
            float4 _SkyGround;

            struct Varyings
            {
                float4 position : SV_POSITION;
                float2 ndc : TEXCOORD0;
            };

            Varyings Vertex(uint id : SV_VertexID)
            {
                Varyings o;
                float2 corner = float2((id << 1) & 2, id & 2) * 2 - 1;
                o.position = float4(corner, UNITY_RAW_FAR_CLIP_VALUE, 1);
                o.ndc = float2(corner.x, corner.y * _ProjectionParams.x);
                return o;
            }

            float4 Fragment(Varyings i) : SV_Target
            {
                // An orthographic camera sees one direction everywhere.
                float4 view = mul(unity_CameraInvProjection, float4(i.ndc, 1, 1));
                float3 ray = unity_OrthoParams.w > 0.5 ? float3(0, 0, -1) : view.xyz / view.w;
                float3 direction = normalize(mul((float3x3)unity_MatrixInvV, ray));
                float up = direction.y;
                float3 above = lerp(_SkyHorizon.rgb, _SkyZenith.rgb, pow(saturate(up), 0.55));
                float3 below = lerp(_SkyHorizon.rgb * 0.85, _SkyGround.rgb, saturate(-up * 6));
                float3 color = lerp(below, above, smoothstep(-0.02, 0.02, up));
                float sun = pow(saturate(dot(direction, _WorldSpaceLightPos0.xyz)), 900);
                return float4(color + sun * float3(1.0, 0.95, 0.85), 1);
            }
            ENDHLSL
        }
    }
}
