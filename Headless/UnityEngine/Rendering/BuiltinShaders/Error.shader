Shader "Hidden/InternalErrorShader"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment
            #include "UnityCG.cginc"

            float4 Vertex(float4 position : POSITION) : SV_POSITION
            {
                return UnityObjectToClipPos(position);
            }

            float4 Fragment() : SV_Target
            {
                return float4(1, 0, 1, 1);
            }
            ENDHLSL
        }
    }
}
