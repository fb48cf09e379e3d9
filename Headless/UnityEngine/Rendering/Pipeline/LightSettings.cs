using System.Linq;
using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Light and ambient variables of shaders.</summary>
internal static class LightSettings
{
    private static readonly int[] LinearBands = [ShaderNames.Id("unity_SHAr"), ShaderNames.Id("unity_SHAg"), ShaderNames.Id("unity_SHAb")];
    private static readonly int[] QuadraticBands = [ShaderNames.Id("unity_SHBr"), ShaderNames.Id("unity_SHBg"), ShaderNames.Id("unity_SHBb")];
    private static readonly int LastBand = ShaderNames.Id("unity_SHC");
    private static readonly int[] PointPositions =
        [ShaderNames.Id("unity_4LightPosX0"), ShaderNames.Id("unity_4LightPosY0"), ShaderNames.Id("unity_4LightPosZ0")];

    private static readonly int PointAttenuation = ShaderNames.Id("unity_4LightAtten0");
    private static readonly int PointColors = ShaderNames.Id("unity_LightColor");

    public static void Apply()
    {
        ApplySun();
        ApplyPointLights();
        ApplyAmbient();
        GlobalKeywords.Set("DIRECTIONAL", true);
    }

    private static void ApplySun()
    {
        PropertySheet sheet = GlobalProperties.Sheet;
        Light? sun = LightList.Main;
        Vector3 direction = sun != null ? -sun.transform.forward : Vector3.up;
        sheet.SetVector(BuiltinNames.LightPosition, new Vector4(direction.x, direction.y, direction.z, 0f));
        sheet.SetVector(BuiltinNames.LightColor, sun != null ? sun.FinalColor : Color.clear);
    }

    /// <summary>The four brightest point and spot lights, as Unity hands them to vertex lighting.</summary>
    private static void ApplyPointLights()
    {
        Light[] lights = [.. LightList.All
            .Where(l => l.type is LightType.Point or LightType.Spot)
            .OrderByDescending(l => l.intensity * l.range).Take(4)];
        var positions = new Vector4[3];
        var attenuation = new Vector4();
        var colors = new Vector4[8];
        for (int i = 0; i < lights.Length; i++)
        {
            Vector3 p = lights[i].transform.position;
            (positions[0][i], positions[1][i], positions[2][i]) = (p.x, p.y, p.z);
            attenuation[i] = 25f / Mathf.Max(1e-4f, lights[i].range * lights[i].range);
            colors[i] = lights[i].FinalColor;
        }

        PropertySheet sheet = GlobalProperties.Sheet;
        for (int axis = 0; axis < 3; axis++)
        {
            sheet.SetVector(PointPositions[axis], positions[axis]);
        }

        sheet.SetVector(PointAttenuation, attenuation);
        sheet.SetVectors(PointColors, colors);
    }

    private static void ApplyAmbient()
    {
        (Color sky, Color equator, Color ground) = AmbientColors();
        PropertySheet sheet = GlobalProperties.Sheet;
        sheet.SetVector(BuiltinNames.AmbientSky, sky);
        sheet.SetVector(BuiltinNames.AmbientEquator, equator);
        sheet.SetVector(BuiltinNames.AmbientGround, ground);

        // UNITY_LIGHTMODEL_AMBIENT is twice this value.
        sheet.SetVector(BuiltinNames.Ambient, (Vector4)sky * 0.5f);

        // a + b y + c y^2 through the three colors, in the basis of ShadeSH9 (y^2 = (1 - z^2 - (x^2 - y^2)) / 2).
        var last = new Vector4();
        for (int c = 0; c < 3; c++)
        {
            float slope = (sky[c] - ground[c]) * 0.5f;
            float curve = ((sky[c] + ground[c]) * 0.5f) - equator[c];
            sheet.SetVector(LinearBands[c], new Vector4(0f, slope, 0f, equator[c] + (curve * 0.5f)));
            sheet.SetVector(QuadraticBands[c], new Vector4(0f, 0f, -curve * 0.5f, 0f));
            last[c] = -curve * 0.5f;
        }

        sheet.SetVector(LastBand, last);
    }

    private static (Color Sky, Color Equator, Color Ground) AmbientColors() => RenderSettings.ambientMode switch
    {
        AmbientMode.Flat => (RenderSettings.ambientSkyColor.linear, RenderSettings.ambientSkyColor.linear, RenderSettings.ambientSkyColor.linear),
        AmbientMode.Trilight => (RenderSettings.ambientSkyColor.linear, RenderSettings.ambientEquatorColor.linear, RenderSettings.ambientGroundColor.linear),
        _ => (
            Sky.AmbientUp * RenderSettings.ambientIntensity,
            Sky.AmbientLevel * RenderSettings.ambientIntensity,
            Sky.AmbientDown * RenderSettings.ambientIntensity),
    };
}
