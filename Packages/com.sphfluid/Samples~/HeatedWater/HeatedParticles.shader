// Particles as round dots that face the camera, coloured by temperature: six vertices a particle, no mesh.
Shader "SPH Fluid Samples/Heated Particles"
{
    SubShader
    {
        Tags { "RenderType" = "TransparentCutout" "Queue" = "AlphaTest" }

        Pass
        {
            Cull Off

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex ExpandDot
            #pragma fragment ShadeDot

            #include "UnityCG.cginc"
            #include "Packages/com.sphfluid/Shaders/FluidBuffers.hlsl"

            StructuredBuffer<float> _Temperatures; // by a particle's Id
            uint _TemperatureCount;

            struct Dot
            {
                float4 clipPosition : SV_Position;
                float2 across : TEXCOORD0; // -1 to 1
                float3 colour : TEXCOORD1;
            };

            // 0 blue, 0.5 white, 1 red
            float3 ColourOf(float temperature)
            {
                const float3 cold = lerp(float3(0.03, 0.16, 0.5), float3(0.9, 0.85, 0.75), saturate(2.0 * temperature));
                return lerp(cold, float3(0.85, 0.08, 0.02), saturate(2.0 * temperature - 1.0));
            }

            Dot ExpandDot(uint vertexId : SV_VertexID)
            {
                const FluidParticle particle = _FluidParticles[vertexId / 6u];
                const uint corner = vertexId % 6u;
                const float2 across = float2(corner == 2u || corner == 4u || corner == 5u ? 1.0 : -1.0,
                    corner == 1u || corner == 2u || corner == 4u ? 1.0 : -1.0);
                const float size = FluidIsAlive(particle) ? 0.6 * _FluidSpacing : 0.0; // what left covers nothing
                const float3 world = FluidToWorld(particle.Position) +
                    size * (across.x * UNITY_MATRIX_V[0].xyz + across.y * UNITY_MATRIX_V[1].xyz);
                Dot result;
                result.clipPosition = mul(UNITY_MATRIX_VP, float4(world, 1.0));
                result.across = across;
                result.colour = ColourOf(_Temperatures[min(particle.Id, _TemperatureCount - 1u)]);
                return result;
            }

            float4 ShadeDot(Dot input) : SV_Target
            {
                const float squared = dot(input.across, input.across);
                clip(1.0 - squared);
                return float4(input.colour * (0.55 + 0.45 * sqrt(saturate(1.0 - squared))), 1.0);
            }
            ENDHLSL
        }
    }
}
