#ifndef UNITY_CG_INCLUDED
#define UNITY_CG_INCLUDED

#define UNITY_PI 3.14159265359f
#define UNITY_TWO_PI 6.28318530718f
#define UNITY_FOUR_PI 12.56637061436f
#define UNITY_INV_PI 0.31830988618f
#define UNITY_INV_TWO_PI 0.15915494309f
#define UNITY_HALF_PI 1.57079632679f

#ifdef UNITY_COLORSPACE_GAMMA
#define unity_ColorSpaceGrey half4(0.5, 0.5, 0.5, 0.5)
#define unity_ColorSpaceLuminance half4(0.22, 0.707, 0.071, 0.0)
#else
#define unity_ColorSpaceGrey half4(0.214041144, 0.214041144, 0.214041144, 0.5)
#define unity_ColorSpaceLuminance half4(0.0396819152, 0.458021790, 0.00609653955, 1.0)
#endif

#include "UnityShaderVariables.cginc"
#include "UnityShaderUtilities.cginc"
#include "UnityInstancing.cginc"

struct appdata_base
{
    float4 vertex : POSITION;
    float3 normal : NORMAL;
    float4 texcoord : TEXCOORD0;
};

struct appdata_tan
{
    float4 vertex : POSITION;
    float4 tangent : TANGENT;
    float3 normal : NORMAL;
    float4 texcoord : TEXCOORD0;
};

struct appdata_full
{
    float4 vertex : POSITION;
    float4 tangent : TANGENT;
    float3 normal : NORMAL;
    float4 texcoord : TEXCOORD0;
    float4 texcoord1 : TEXCOORD1;
    float4 texcoord2 : TEXCOORD2;
    float4 texcoord3 : TEXCOORD3;
    half4 color : COLOR;
};

struct appdata_img
{
    float4 vertex : POSITION;
    half2 texcoord : TEXCOORD0;
};

struct v2f_img
{
    float4 pos : SV_POSITION;
    half2 uv : TEXCOORD0;
};

v2f_img vert_img(appdata_img v)
{
    v2f_img o;
    o.pos = UnityObjectToClipPos(v.vertex);
    o.uv = v.texcoord;
    return o;
}

#define TRANSFORM_TEX(tex, name) (tex.xy * name##_ST.xy + name##_ST.zw)

float4 UnityWorldToClipPos(float3 position)
{
    return mul(unity_MatrixVP, float4(position, 1.0));
}

float4 UnityViewToClipPos(float3 position)
{
    return mul(glstate_matrix_projection, float4(position, 1.0));
}

float3 UnityObjectToViewPos(float3 position)
{
    return mul(unity_MatrixV, mul(unity_ObjectToWorld, float4(position, 1.0))).xyz;
}

float3 UnityObjectToViewPos(float4 position)
{
    return UnityObjectToViewPos(position.xyz);
}

float3 UnityWorldToViewPos(float3 position)
{
    return mul(unity_MatrixV, float4(position, 1.0)).xyz;
}

float3 UnityObjectToWorldDir(float3 direction)
{
    return normalize(mul((float3x3)unity_ObjectToWorld, direction));
}

float3 UnityWorldToObjectDir(float3 direction)
{
    return normalize(mul((float3x3)unity_WorldToObject, direction));
}

// The inverse transpose of the object's matrix: mul with the row vector on the left.
float3 UnityObjectToWorldNormal(float3 normal)
{
    return normalize(mul(normal, (float3x3)unity_WorldToObject));
}

float3 UnityWorldSpaceLightDir(float3 position)
{
    return _WorldSpaceLightPos0.xyz - position * _WorldSpaceLightPos0.w;
}

float3 WorldSpaceLightDir(float4 localPosition)
{
    return UnityWorldSpaceLightDir(mul(unity_ObjectToWorld, localPosition).xyz);
}

float3 UnityWorldSpaceViewDir(float3 position)
{
    return _WorldSpaceCameraPos.xyz - position;
}

float3 WorldSpaceViewDir(float4 localPosition)
{
    return UnityWorldSpaceViewDir(mul(unity_ObjectToWorld, localPosition).xyz);
}

float3 ObjSpaceViewDir(float4 localPosition)
{
    return mul(unity_WorldToObject, float4(_WorldSpaceCameraPos.xyz, 1.0)).xyz - localPosition.xyz;
}

float3 ObjSpaceLightDir(float4 localPosition)
{
    float3 light = mul(unity_WorldToObject, _WorldSpaceLightPos0).xyz;
    return light - localPosition.xyz * _WorldSpaceLightPos0.w;
}

float LinearEyeDepth(float z)
{
    return 1.0 / (_ZBufferParams.z * z + _ZBufferParams.w);
}

float Linear01Depth(float z)
{
    return 1.0 / (_ZBufferParams.x * z + _ZBufferParams.y);
}

float4 ComputeNonStereoScreenPos(float4 clipPosition)
{
    float4 o = clipPosition * 0.5f;
    o.xy = float2(o.x, o.y * _ProjectionParams.x) + o.w;
    o.zw = clipPosition.zw;
    return o;
}

float4 ComputeScreenPos(float4 clipPosition)
{
    return ComputeNonStereoScreenPos(clipPosition);
}

float4 ComputeGrabScreenPos(float4 clipPosition)
{
    float4 o = clipPosition * 0.5f;
    o.xy = float2(o.x, -o.y) + o.w;
    o.zw = clipPosition.zw;
    return o;
}

#define COMPUTE_EYEDEPTH(o) o = -UnityObjectToViewPos(v.vertex).z
#define COMPUTE_DEPTH_01 -(UnityObjectToViewPos(v.vertex).z * (1.0 / _ProjectionParams.z))
#define COMPUTE_VIEW_NORMAL normalize(mul((float3x3)unity_MatrixV, UnityObjectToWorldNormal(v.normal)))

half Luminance(half3 color)
{
    return dot(color, unity_ColorSpaceLuminance.rgb);
}

half3 DecodeHDR(half4 data, half4 decodeInstructions)
{
    half alpha = decodeInstructions.w * (data.a - 1.0) + 1.0;
    return decodeInstructions.x * pow(max(alpha, 0.0), decodeInstructions.y) * data.rgb;
}

half3 GammaToLinearSpace(half3 color)
{
    return color * (color * (color * 0.305306011h + 0.682171111h) + 0.012522878h);
}

half3 LinearToGammaSpace(half3 color)
{
    color = max(color, half3(0.0h, 0.0h, 0.0h));
    return max(1.055h * pow(color, 0.416666667h) - 0.055h, 0.0h);
}

half3 UnpackNormal(half4 packed)
{
    half3 normal;
    normal.xy = half2(packed.x * packed.w, packed.y) * 2 - 1;
    normal.z = sqrt(1 - saturate(dot(normal.xy, normal.xy)));
    return normal;
}

half3 SHEvalLinearL0L1(half4 normal)
{
    return half3(dot(unity_SHAr, normal), dot(unity_SHAg, normal), dot(unity_SHAb, normal));
}

half3 SHEvalLinearL2(half4 normal)
{
    half4 products = normal.xyzz * normal.yzzx;
    half3 light = half3(dot(unity_SHBr, products), dot(unity_SHBg, products), dot(unity_SHBb, products));
    return light + unity_SHC.rgb * (normal.x * normal.x - normal.y * normal.y);
}

half3 ShadeSH9(half4 normal)
{
    half3 light = SHEvalLinearL0L1(normal) + SHEvalLinearL2(normal);
#ifdef UNITY_COLORSPACE_GAMMA
    light = LinearToGammaSpace(light);
#endif
    return light;
}

// Lambert's light of four point lights; light / (1 + a d^2), without an end at the lights' range.
float3 Shade4PointLights(
    float4 lightX, float4 lightY, float4 lightZ, float3 color0, float3 color1, float3 color2, float3 color3, float4 attenuation,
    float3 position, float3 normal)
{
    float4 toX = lightX - position.x;
    float4 toY = lightY - position.y;
    float4 toZ = lightZ - position.z;
    float4 squared = max(toX * toX + toY * toY + toZ * toZ, 1e-6);
    float4 cosine = saturate((toX * normal.x + toY * normal.y + toZ * normal.z) * rsqrt(squared));
    float4 light = cosine / (1.0 + squared * attenuation);
    return color0 * light.x + color1 * light.y + color2 * light.z + color3 * light.w;
}

float4 UnityApplyLinearShadowBias(float4 clipPosition)
{
    clipPosition.z += max(-1.0, min(unity_LightShadowBias.x / clipPosition.w, 0.0));
    float clamped = min(clipPosition.z, clipPosition.w * UNITY_NEAR_CLIP_VALUE);
    clipPosition.z = lerp(clipPosition.z, clamped, unity_LightShadowBias.y);
    return clipPosition;
}

// Moves the caster against its normal by up to unity_LightShadowBias.z texels where light grazes it.
float4 UnityClipSpaceShadowCasterPos(float4 vertex, float3 normal)
{
    float4 position = mul(unity_ObjectToWorld, vertex);
    if (unity_LightShadowBias.z != 0.0)
    {
        float3 worldNormal = UnityObjectToWorldNormal(normal);
        float3 light = normalize(UnityWorldSpaceLightDir(position.xyz));
        float cosine = dot(worldNormal, light);
        position.xyz -= worldNormal * (unity_LightShadowBias.z * sqrt(1.0 - cosine * cosine));
    }
    return mul(unity_MatrixVP, position);
}

#define V2F_SHADOW_CASTER_NOPOS
#define V2F_SHADOW_CASTER float4 pos : SV_POSITION
#define TRANSFER_SHADOW_CASTER_NOPOS(o, opos) \
    opos = UnityClipSpaceShadowCasterPos(v.vertex, v.normal); \
    opos = UnityApplyLinearShadowBias(opos);
#define TRANSFER_SHADOW_CASTER_NOPOS_LEGACY(o, opos) \
    opos = UnityObjectToClipPos(v.vertex.xyz); \
    opos = UnityApplyLinearShadowBias(opos);
#define TRANSFER_SHADOW_CASTER(o) TRANSFER_SHADOW_CASTER_NOPOS_LEGACY(o, o.pos)
#define TRANSFER_SHADOW_CASTER_NORMALOFFSET(o) TRANSFER_SHADOW_CASTER_NOPOS(o, o.pos)
#define SHADOW_CASTER_FRAGMENT(i) return 0;

#define UNITY_FOG_COORDS(index)
#define UNITY_TRANSFER_FOG(o, clipPosition)
#define UNITY_APPLY_FOG(coord, color)
#define UNITY_APPLY_FOG_COLOR(coord, color, fogColor)

#endif
