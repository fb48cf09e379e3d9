using UnityEngine;
using UnityEngine.Rendering;
using static UnityEngine.Rendering.Universal.RenderPassEvent;

namespace Headless.Tests.Universal;

/// <summary>The variables, textures and keywords that the pipeline sets for shaders. Headless/UnityUniversal/FACTS.md is made of this table.</summary>
public static class UniversalFacts
{
    private static readonly string[] Matrix4 = ["{0}[0]", "{0}[1]", "{0}[2]", "{0}[3]"];

    public static IReadOnlyList<Fact> All { get; } =
    [
        Vector("_WorldSpaceCameraPos", BeforeRenderingPrePasses, "the camera's position", "m", "float3 {0};", "float4({0}, 0.0)", s => s.Camera.transform.position),
        Vector("_ScreenParams", BeforeRenderingPrePasses, "width, height, 1 + 1 / width, 1 + 1 / height of the camera's rectangle", "pixels", s => Params(s.Size)),
        Vector("_ScaledScreenParams", BeforeRenderingPrePasses, "as _ScreenParams, times the render scale", "pixels", s => Params(s.TargetSize)),
        Vector("_ScreenSize", BeforeRenderingPrePasses, "scaled width, height and their reciprocals", "pixels", s => new Vector4(s.TargetSize.x, s.TargetSize.y, 1f / s.TargetSize.x, 1f / s.TargetSize.y)),
        Vector("_ProjectionParams", BeforeRenderingPrePasses, "-1 into a texture, near plane, far plane, 1 / far", "m", s => new Vector4(-1f, s.Camera.nearClipPlane, s.Camera.farClipPlane, 1f / s.Camera.farClipPlane)),
        Vector("_ZBufferParams", BeforeRenderingPrePasses, "far / near - 1, 1, x / far, 1 / far", "", Buffer),
        Vector("unity_OrthoParams", BeforeRenderingPrePasses, "half width, half height of an orthographic view, 0, 1 if it is one", "m", s => new Vector4(s.Camera.orthographicSize * s.Camera.aspect, s.Camera.orthographicSize, 0f, 0f)),
        Matrix("unity_MatrixV", BeforeRenderingPrePasses, "world to view, looking along -z", s => s.View),
        Matrix("glstate_matrix_projection", BeforeRenderingPrePasses, "view to clip: upside down for textures, depth from 1 to 0", s => s.DeviceProjection),
        Matrix("unity_MatrixVP", BeforeRenderingPrePasses, "the product of the two before", s => s.DeviceProjection * s.View),
        Matrix("unity_MatrixInvV", BeforeRenderingPrePasses, "inverse of unity_MatrixV", s => s.View.inverse),
        Matrix("unity_MatrixInvP", BeforeRenderingPrePasses, "inverse of the device's projection", s => s.DeviceProjection.inverse),
        Matrix("unity_MatrixInvVP", BeforeRenderingPrePasses, "inverse of unity_MatrixVP", s => (s.DeviceProjection * s.View).inverse),
        Matrix("unity_WorldToCamera", BeforeRenderingPrePasses, "world to view, looking along +z", s => s.Camera.transform.worldToLocalMatrix),
        Matrix("unity_CameraToWorld", BeforeRenderingPrePasses, "its inverse", s => s.Camera.transform.localToWorldMatrix),
        Matrix("unity_CameraProjection", BeforeRenderingPrePasses, "view to clip as in OpenGL", s => s.Camera.projectionMatrix),
        Vector("_GlobalMipBias", BeforeRenderingPrePasses, "-log2 of the scale, at most 0; 2 to the power of it", "", "float2 {0};", "float4({0}, 0.0, 0.0)", s => new Vector2(0f, 1f)),
        Vector("_RTHandleScale", BeforeRenderingPrePasses, "1: no texture is larger than what is drawn", "", _ => Vector4.one),
        Vector("_Time", BeforeRenderingPrePasses, "t / 20, t, 2 t, 3 t since the scene was loaded", "s", _ => Time.timeSinceLevelLoad * new Vector4(0.05f, 1f, 2f, 3f)),
        Vector("_TimeParameters", BeforeRenderingPrePasses, "t, sin t, cos t, 0", "s", _ => new Vector4(Time.time, Mathf.Sin(Time.time), Mathf.Cos(Time.time), 0f)),
        Vector("_MainLightPosition", BeforeRenderingPrePasses, "unit vector to the main light, 0", "", s => FactScene.Toward(s.Sun)),
        Vector("_MainLightColor", BeforeRenderingPrePasses, "linear colour times intensity, 1", "", s => FactScene.Linear(s.Sun, 1f)),
        Vector("_AdditionalLightsCount", BeforeRenderingPrePasses, "the most that one object may have", "", s => new Vector4(s.Asset.maxAdditionalLightsCount, 0f, 0f, 0f)),
        Lights("_AdditionalLightsPosition", "position, 1; to a directional light, 0", "m", s => [FactScene.Place(s.Lamp), FactScene.Place(s.Spot)]),
        Lights("_AdditionalLightsColor", "linear colour times intensity, 0", "", s => [FactScene.Linear(s.Lamp, 0f), FactScene.Linear(s.Spot, 0f)]),
        Lights("_AdditionalLightsAttenuation", "1 / range², 1 / 0.36, 1 / (cos inner - cos outer), -cos outer times it; 0, 1 without a cone", "1/m²", s => [Attenuation(s.Lamp, 0f, 1f), Spot(s.Spot)]),
        Lights("_AdditionalLightsSpotDir", "unit vector against the spot's own", "", s => [new Vector4(0f, 0f, 1f, 0f), FactScene.Toward(s.Spot)]),
        new("_MainLightWorldToShadow", AfterRenderingShadows, "world to the cascade's square of the map, depth from 1 to 0; the fifth of no meaning: zeros, depth 1", "", "float4x4 _MainLightWorldToShadow[5];", [.. Matrix4.Select(m => string.Format(m, "_MainLightWorldToShadow[4]"))], _ => [Vector4.zero, Vector4.zero, new Vector4(0f, 0f, 1f, 0f), Vector4.zero]),
        Vector("_MainLightShadowParams", AfterRenderingShadows, "strength, 1 for soft shadows, scale and bias of the fade over the squared distance", "", Params),
        Sphere(0), Sphere(1), Sphere(2), Sphere(3),
        Vector("_CascadeShadowSplitSphereRadii", AfterRenderingShadows, "squares of the four spheres' w", "m²", "float4 {0}; float4 _CascadeShadowSplitSpheres0; float4 _CascadeShadowSplitSpheres3;", "{0} / float4(_CascadeShadowSplitSpheres0.w * _CascadeShadowSplitSpheres0.w, {0}.yz, _CascadeShadowSplitSpheres3.w * _CascadeShadowSplitSpheres3.w)", _ => Vector4.one),
        Vector("_MainLightShadowmapSize", AfterRenderingShadows, "1 / width, 1 / height, width, height; set only where soft shadows are supported", "pixels", _ => new Vector4(1f / 2048f, 1f / 2048f, 2048f, 2048f)),
        Vector("_MainLightShadowOffset0", AfterRenderingShadows, "half a texel: -x, -y, x, -y", "", _ => new Vector4(-1f, -1f, 1f, -1f) / 4096f),
        Vector("_MainLightShadowOffset1", AfterRenderingShadows, "half a texel: -x, y, x, y", "", _ => new Vector4(-1f, 1f, 1f, 1f) / 4096f),
        Size("_MainLightShadowmapTexture", AfterRenderingShadows, "four squares, two by two; depth for comparison", _ => new Vector2(2048f, 2048f)),
        Vector("_ShadowBias", AfterRenderingShadows, "along the light and along the normal of a caster, both away from the light: bias times a texel of the last cascade times the filter's reach; 1 for a directional light", "m", "float4 {0};", "float4(sign({0}.xy), {0}.zw)", _ => new Vector4(-1f, -1f, 1f, 0f)),
        Vector("_LightDirection", AfterRenderingShadows, "unit vector to the light that cast last", "", "float3 {0};", "float4({0}, 0.0)", s => FactScene.Toward(s.Sun)),
        Size("_CameraDepthTexture", BeforeRenderingTransparents, "depth as the device has it, copied after the sky or drawn before the opaques", s => s.TargetSize),
        Size("_CameraOpaqueTexture", BeforeRenderingTransparents, "the picture before transparents, by default at half size", s => new Vector2((int)(s.TargetSize.x / 2f), (int)(s.TargetSize.y / 2f))),
        Size("_CameraNormalsTexture", BeforeRenderingOpaques, "world normals of the prepass, where a pass asks for them", s => s.TargetSize),
        Vector("_GlossyEnvironmentColor", BeforeRenderingPrePasses, "constant band of the ambient probe times the reflection intensity", "", Glossy),
        Vector("_GlossyEnvironmentCubeMap_HDR", BeforeRenderingPrePasses, "decoding of the reflection outside all probes", "", _ => ReflectionProbe.defaultTextureHDRDecodeValues),
        Vector("unity_AmbientSky", BeforeRenderingPrePasses, "linear ambient colour from above", "", _ => RenderSettings.ambientSkyColor.linear),
        Vector("unity_AmbientEquator", BeforeRenderingPrePasses, "from the side", "", _ => RenderSettings.ambientEquatorColor.linear),
        Vector("unity_AmbientGround", BeforeRenderingPrePasses, "from below", "", _ => RenderSettings.ambientGroundColor.linear),
        Vector("_SubtractiveShadowColor", BeforeRenderingPrePasses, "RenderSettings.subtractiveShadowColor, linear", "", _ => RenderSettings.subtractiveShadowColor.linear),
        Vector("_DrawObjectPassData", AfterRenderingOpaques, "0, 0, 0, 1 in the opaque pass, 0 in the transparent", "", "float4 {0};", "{0}", _ => new Vector4(0f, 0f, 0f, 1f)),
        Vector("_ScaleBiasRt", AfterRenderingOpaques, "-1, 1, -1, 1 into a texture; 1, 0, 1, 1 to the screen", "", _ => new Vector4(-1f, 1f, -1f, 1f)),
        Keyword("_MAIN_LIGHT_SHADOWS_CASCADE", AfterRenderingShadows, "shadows of the main light, two cascades or more", 1f),
        Keyword("_MAIN_LIGHT_SHADOWS", AfterRenderingShadows, "one cascade, or no caster in view", 0f),
        Keyword("_SHADOWS_SOFT", AfterRenderingShadows, "the asset supports soft shadows and the light has them", 1f),
        Keyword("_ADDITIONAL_LIGHTS", BeforeRenderingPrePasses, "additional lights, an object's list each (Forward)", 1f),
        Keyword("_FORWARD_PLUS", BeforeRenderingPrePasses, "additional lights by clusters, up to 6000.0", 0f),
        Keyword("_CLUSTER_LIGHT_LOOP", BeforeRenderingPrePasses, "additional lights by clusters, from 6000.1 on", 0f),
    ];

    private static Fact Vector(string name, UnityEngine.Rendering.Universal.RenderPassEvent from, string formula, string unit, Func<FactScene, Vector4> expected) =>
        Vector(name, from, formula, unit, "float4 {0};", "{0}", expected);

    private static Fact Vector(
        string name, UnityEngine.Rendering.Universal.RenderPassEvent from, string formula, string unit, string declaration, string value,
        Func<FactScene, Vector4> expected) =>
        new(name, from, formula, unit, string.Format(declaration, name), [string.Format(value, name)], s => [expected(s)]);

    private static Fact Matrix(string name, UnityEngine.Rendering.Universal.RenderPassEvent from, string formula, Func<FactScene, Matrix4x4> expected) =>
        new(name, from, formula, "m", $"float4x4 {name};", [.. Matrix4.Select(m => string.Format(m, name))], s => FactScene.Rows(expected(s)));

    private static Fact Lights(string name, string formula, string unit, Func<FactScene, Vector4[]> expected) =>
        new(name, BeforeRenderingPrePasses, formula, unit, $"float4 {name}[256];", [$"{name}[0]", $"{name}[1]"], expected);

    private static Fact Size(string name, UnityEngine.Rendering.Universal.RenderPassEvent from, string formula, Func<FactScene, Vector2> expected) =>
        new(name, from, formula, "pixels", $"Texture2D {name}; float4 Size{name}() {{ float2 size = 0.0; {name}.GetDimensions(size.x, size.y); return float4(size, 0.0, 0.0); }}", [$"Size{name}()"], s => [expected(s)]);

    private static Fact Sphere(int index) =>
        Vector($"_CascadeShadowSplitSpheres{index}", AfterRenderingShadows, $"centre and radius of what cascade {index} holds", "m", "float4 {0};", "float4({0}.w > 0.0, 0.0, 0.0, 0.0)", _ => new Vector4(1f, 0f, 0f, 0f));

    private static Fact Keyword(string name, UnityEngine.Rendering.Universal.RenderPassEvent from, string formula, float expected) =>
        new(name, from, formula, "", $"\n#if defined({name})\nstatic const float Has{name} = 1.0;\n#else\nstatic const float Has{name} = 0.0;\n#endif\n", [$"float4(Has{name}, 0.0, 0.0, 0.0)"], _ => [new Vector4(expected, 0f, 0f, 0f)]);

    private static Vector4 Params(Vector2 size) => new(size.x, size.y, 1f + (1f / size.x), 1f + (1f / size.y));

    private static Vector4 Params(FactScene scene)
    {
        float far = scene.Asset.shadowDistance * scene.Asset.shadowDistance;
        float near = far * (1f - scene.Asset.cascadeBorder) * (1f - scene.Asset.cascadeBorder);
        return new Vector4(scene.Sun.shadowStrength, 1f, 1f / (far - near), -near / (far - near));
    }

    private static Vector4 Buffer(FactScene scene)
    {
        (float near, float far) = (scene.Camera.nearClipPlane, scene.Camera.farClipPlane);
        return new Vector4((far / near) - 1f, 1f, ((far / near) - 1f) / far, 1f / far);
    }

    private static Vector4 Glossy(FactScene scene)
    {
        SphericalHarmonicsL2 probe = RenderSettings.ambientProbe;
        return new Color(probe[0, 0], probe[1, 0], probe[2, 0]) * RenderSettings.reflectionIntensity;
    }

    private static Vector4 Attenuation(Light light, float z, float w) => new(1f / (light.range * light.range), 1f / 0.36f, z, w);

    private static Vector4 Spot(Light light)
    {
        float outer = Mathf.Cos(light.spotAngle * Mathf.Deg2Rad * 0.5f);
        float inner = Mathf.Cos(light.innerSpotAngle * Mathf.Deg2Rad * 0.5f);
        return Attenuation(light, 1f / (inner - outer), -outer / (inner - outer));
    }
}
