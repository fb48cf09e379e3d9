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

    /// <summary>The four brightest point lights, as Unity hands them to vertex lighting.</summary>
    private static void ApplyPointLights()
    {
        LightLimits.Report();
        Light[] lights = [.. LightLimits.Points.Take(LightLimits.MaxPoints)];
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
        (Color sky, Color equator, Color ground) = AmbientLight.Colors();
        PropertySheet sheet = GlobalProperties.Sheet;
        sheet.SetVector(BuiltinNames.AmbientSky, sky);
        sheet.SetVector(BuiltinNames.AmbientEquator, equator);
        sheet.SetVector(BuiltinNames.AmbientGround, ground);

        // UNITY_LIGHTMODEL_AMBIENT is twice this value.
        sheet.SetVector(BuiltinNames.Ambient, (Vector4)sky * 0.5f);

        SphericalHarmonicsL2 probe = RenderSettings.ambientProbe;
        for (int c = 0; c < 3; c++)
        {
            sheet.SetVector(LinearBands[c], new Vector4(probe[c, 3], probe[c, 1], probe[c, 2], probe[c, 0] - probe[c, 6]));
            sheet.SetVector(QuadraticBands[c], new Vector4(probe[c, 4], probe[c, 5], probe[c, 6] * 3f, probe[c, 7]));
        }

        sheet.SetVector(LastBand, new Vector4(probe[0, 8], probe[1, 8], probe[2, 8], 1f));
    }
}
