Shader "Hidden/BlitCopy"
{
    Properties
    {
        _MainTex ("Texture", 2D) = "white" {}
    }
    SubShader
    {
        Tags { "RenderType" = "Opaque" }

        Pass
        {
            ZTest Always
            ZWrite Off
            Cull Off

            HLSLPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile_local _ SOURCE_ARRAY
            #include "UnityCG.cginc"

            #if defined(SOURCE_ARRAY)
            Texture2DArray _MainTex;
            float _Slice;
            #define PLACE(uv) float3(uv, _Slice)
            #else
            Texture2D _MainTex;
            #define PLACE(uv) uv
            #endif
            SamplerState sampler_MainTex;
            float4 _MainTex_ST;
            float4 _Color;

            struct Attributes
            {
                float4 position : POSITION;
                float4 color : COLOR;
                float2 uv : TEXCOORD0;
            };

            struct Varyings
            {
                float4 position : SV_POSITION;
                float4 color : COLOR;
                float2 uv : TEXCOORD0;
            };

            Varyings Vertex(Attributes v)
            {
                Varyings o;
                o.position = UnityObjectToClipPos(v.position);
                o.color = v.color;
                o.uv = v.uv * _MainTex_ST.xy + _MainTex_ST.zw;
                return o;
            }

            float4 Fragment(Varyings i) : SV_Target
            {
                return _MainTex.Sample(sampler_MainTex, PLACE(i.uv));
            }
            ENDHLSL
        }
    }
}
