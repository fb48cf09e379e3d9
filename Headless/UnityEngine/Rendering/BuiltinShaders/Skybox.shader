// A plain gradient with a small sun.
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

            // Linear colors.
            static const float3 Zenith = float3(0.16, 0.27, 0.48);
            static const float3 Horizon = float3(0.60, 0.68, 0.76);
            static const float3 Ground = float3(0.20, 0.19, 0.18);

            struct Varyings
            {
                float4 position : SV_POSITION;
                float3 direction : TEXCOORD0;
            };

            Varyings Vertex(float4 position : POSITION)
            {
                Varyings o;
                o.position = UnityObjectToClipPos(position);
                o.direction = mul((float3x3)unity_ObjectToWorld, position.xyz);
                return o;
            }

            float4 Fragment(Varyings i) : SV_Target
            {
                float3 direction = normalize(i.direction);
                float up = direction.y;
                float3 above = lerp(Horizon, Zenith, pow(saturate(up), 0.55));
                float3 below = lerp(Horizon * 0.85, Ground, saturate(-up * 6));
                float3 color = lerp(below, above, smoothstep(-0.02, 0.02, up));
                float sun = pow(saturate(dot(direction, _WorldSpaceLightPos0.xyz)), 900);
                return float4(color + sun * float3(1.0, 0.95, 0.85), 1);
            }
            ENDHLSL
        }
    }
}
