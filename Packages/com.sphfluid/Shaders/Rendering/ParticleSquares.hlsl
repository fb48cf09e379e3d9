// Particles as textured, lit squares that face the camera (Fig. 12 of the thesis, left). The vertex stage expands them: six vertices a
// particle, no geometry shader.
#ifndef SPHFLUID_PARTICLE_SQUARES_INCLUDED
#define SPHFLUID_PARTICLE_SQUARES_INCLUDED

#include "../Gpu/FluidTypes.hlsl"
#include "ReceivedShadow.hlsl"

StructuredBuffer<Particle> _Particles;
Texture2D _MainTex;
SamplerState sampler_MainTex;
float4 _MainTex_ST;
float4 _Color;
float4 _FastColor;
float _ParticleSize; // edge of a square [m]
float _FastSpeed;    // speed that has the fast colour in full [m/s]; 0: every particle has _Color
float _Smoothness;

#define ALPHA_THRESHOLD 0.5

struct SquareFragment
{
    float4 clipPosition : SV_Position;
    float3 world : TEXCOORD0;
    float2 uv : TEXCOORD1;
    float3 colour : TEXCOORD2;
    EYE_FIELD
};

// Corners of two triangles, clockwise: (0,0) (0,1) (1,1) and (0,0) (1,1) (1,0).
float2 SquareCorner(uint index)
{
    float x = index == 2 || index == 4 || index == 5 ? 1.0 : 0.0;
    float y = index == 1 || index == 2 || index == 4 ? 1.0 : 0.0;
    return float2(x, y);
}

SquareFragment ExpandSquare(uint vertexId : SV_VertexID EYE_PARAMETER)
{
    EYE_OF_INSTANCE
    Particle particle = _Particles[vertexId / 6];
    float2 uv = SquareCorner(vertexId % 6);
    float2 offset = (uv - 0.5) * (particle.Removed == 0.0 ? _ParticleSize : 0.0); // one that left the domain covers nothing

    SquareFragment output;
    EYE_TO(output)
    float3 aside = unity_MatrixV[0].xyz * offset.x + unity_MatrixV[1].xyz * offset.y;
    output.world = FluidWorldPosition(particle.Position) + aside;
    output.uv = uv;
    float share = _FastSpeed > 0.0 ? saturate(length(particle.VelT1) / _FastSpeed) : 0.0;
    output.colour = lerp(_Color.rgb, _FastColor.rgb, share);
    output.clipPosition = FluidClipOfLocal(particle.Position, aside);
#if defined(FLUID_SHADOW_CASTER)
    output.clipPosition = FluidShadowClipPosition(output.clipPosition);
#endif
    return output;
}

float4 SampleSprite(float2 uv)
{
    float4 sprite = _MainTex.Sample(sampler_MainTex, uv * _MainTex_ST.xy + _MainTex_ST.zw);
    clip(sprite.a - ALPHA_THRESHOLD);
    return sprite;
}

// The square is lit as if a ball stood on it.
float3 BallNormal(float2 uv)
{
    float2 across = uv * 2.0 - 1.0;
    float towards = sqrt(saturate(1.0 - dot(across, across)));
    float3 normal = unity_MatrixV[0].xyz * across.x + unity_MatrixV[1].xyz * across.y + unity_MatrixV[2].xyz * towards;
    return normalize(normal);
}

float4 ShadeSquare(SquareFragment input) : SV_Target
{
    EYE_OF(input)
    float4 sprite = SampleSprite(input.uv);
    float3 normal = BallNormal(input.uv);
    float3 view = normalize(_WorldSpaceCameraPos - input.world);
    float3 ball = input.world + _FluidLightDirection.xyz * (0.5 * _ParticleSize); // before the squares of neighbours, which cast the shadow
    float sun = ReceivedSun(ball, 0.0);
    float3 colour = FluidDiffuse(input.colour * sprite.rgb, normal, sun);
    colour += FluidHighlight(_Smoothness, normal, view) * sun;
    return float4(FluidExposed(colour), 1.0);
}

float4 CastSquareShadow(SquareFragment input) : SV_Target
{
    SampleSprite(input.uv);
    return 0.0;
}

float4 ShowSquareDepth(SquareFragment input) : SV_Target
{
    SampleSprite(input.uv);
    return input.clipPosition.z;
}

float4 ShowSquareNormal(SquareFragment input) : SV_Target
{
    EYE_OF(input)
    SampleSprite(input.uv);
    return float4(BallNormal(input.uv), 0.0);
}

#endif
