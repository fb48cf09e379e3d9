Shader "Terrace/Surface"
{
    Properties
    {
        _Tint ("Tint", Color) = (1, 1, 1, 1)
        _Source ("Source", Float) = 1
        _Destination ("Destination", Float) = 0
    }

    // Of another pipeline: magenta where it is taken by mistake.
    SubShader
    {
        Tags { "RenderPipeline" = "OtherPipeline" }
        Pass
        {
            Tags { "LightMode" = "Terrace" }
            CGPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #include "UnityCG.cginc"
            float4 vert(float4 vertex : POSITION) : SV_POSITION { return UnityObjectToClipPos(vertex); }
            float4 frag() : SV_Target { return float4(1, 0, 1, 1); }
            ENDCG
        }
    }

    SubShader
    {
        Tags { "RenderPipeline" = "TerracePipeline" }
        Pass
        {
            Tags { "LightMode" = "Terrace" }
            Blend [_Source] [_Destination]
            CGPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #include "UnityCG.cginc"

            Texture2D _TerraceShadows;
            SamplerComparisonState sampler_TerraceShadows;
            float4x4 _TerraceWorldToShadow;
            float4 _TerraceSunColor;
            float4 _Tint;

            struct v2f
            {
                float4 position : SV_POSITION;
                float3 world : TEXCOORD0;
            };

            v2f vert(appdata_base v)
            {
                v2f o;
                o.position = UnityObjectToClipPos(v.vertex);
                o.world = mul(unity_ObjectToWorld, v.vertex).xyz;
                return o;
            }

            float4 frag(v2f i) : SV_Target
            {
                float3 place = mul(_TerraceWorldToShadow, float4(i.world, 1)).xyz;
                float sun = _TerraceShadows.SampleCmpLevelZero(sampler_TerraceShadows, place.xy, place.z);
                return float4(_Tint.rgb * _TerraceSunColor.rgb * lerp(0.25, 1, sun), _Tint.a);
            }
            ENDCG
        }
        Pass
        {
            Tags { "LightMode" = "ShadowCaster" }
            ColorMask 0
            CGPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #include "UnityCG.cginc"
            float4 vert(float4 vertex : POSITION) : SV_POSITION { return UnityObjectToClipPos(vertex); }
            float4 frag() : SV_Target { return 0; }
            ENDCG
        }
    }
}
